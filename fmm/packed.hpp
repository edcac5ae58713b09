#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "fmm/lanes.hpp"

namespace vortree::fmm {

/// Sources side by side for a near sum, the last vector filled up with sources of no strength.
class Packed {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const double* x() const { return values_.data(); }
  [[nodiscard]] const double* y() const { return values_.data() + room_; }
  [[nodiscard]] const double* gamma() const { return values_.data() + 2 * room_; }
  [[nodiscard]] const double* core() const { return values_.data() + 3 * room_; }

  /// Empty, with room for n sources.
  void restart(std::size_t n) {
    size_ = 0;
    if (room_ >= padded(n)) return;
    room_ = padded(n + n / 2);
    values_.resize(4 * room_);
  }

  void add(double x, double y, double gamma, double core) {
    double* to = values_.data() + size_++;
    to[0] = x, to[room_] = y, to[2 * room_] = gamma, to[3 * room_] = core;
  }

  void close() {
    const std::size_t sources = size_;
    while (size_ % lane_count != 0) add(x()[0], y()[0], 0.0, core()[0]);
    size_ = sources;
  }

 private:
  std::size_t size_ = 0, room_ = 0;
  std::vector<double> values_;  // x, y, gamma, core, each `room_` long
};

}  // namespace vortree::fmm
