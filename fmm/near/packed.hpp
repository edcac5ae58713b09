#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// Sources side by side for a near sum, the last vector filled up with sources of no strength.
class PackedSources {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const double* x() const { return values_.data(); }
  [[nodiscard]] const double* y() const { return values_.data() + room_; }
  [[nodiscard]] const double* gamma() const { return values_.data() + 2 * room_; }
  [[nodiscard]] const double* core() const { return values_.data() + 3 * room_; }
  [[nodiscard]] double* core() { return values_.data() + 3 * room_; }

  /// Empty, with room for n sources.
  void restart(std::size_t n) {
    size_ = 0;
    if (room_ >= padded(n) + lane_count) return;
    room_ = padded(n + n / 2) + lane_count;
    values_.resize(4 * room_);
  }

  void add(double x, double y, double gamma, double core) {
    double* to = values_.data() + size_++;
    to[0] = x, to[room_] = y, to[2 * room_] = gamma, to[3 * room_] = core;
  }

  /// Adds chosen lanes; a value to keep in registers while many are added. Without cores if the
  /// sources are bare.
  class Writer {
   public:
    explicit Writer(PackedSources& packed)
        : to_(packed.values_.data() + packed.size_), room_(packed.room_) {}

    void add(Lanes x, Lanes y, Lanes gamma, LaneSet chosen) {
      store_close(to_, x, chosen);
      store_close(to_ + room_, y, chosen);
      store_close(to_ + 2 * room_, gamma, chosen);
      to_ += std::popcount(chosen);
    }
    void add(Lanes x, Lanes y, Lanes gamma, Lanes core, LaneSet chosen) {
      store_close(to_ + 3 * room_, core, chosen);
      add(x, y, gamma, chosen);
    }
    void finish(PackedSources& packed) const {
      packed.size_ = static_cast<std::size_t>(to_ - packed.values_.data());
    }

   private:
    double* to_;
    std::size_t room_;
  };

  /// Bare sources, `count` in a row.
  void add(const double* x, const double* y, const double* gamma, std::size_t count) {
    double* to = values_.data() + size_;
    std::copy_n(x, count, to);
    std::copy_n(y, count, to + room_);
    std::copy_n(gamma, count, to + 2 * room_);
    size_ += count;
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
