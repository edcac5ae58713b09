#pragma once

#include <cstddef>
#include <vector>

#include "fmm/cores/core_kernel.hpp"
#include "fmm/near/p2p_kernel.hpp"
#include "fmm/near/packed.hpp"
#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// Cored near sums in single precision, twice as fast as p2p, for tolerances it satisfies.
///
/// Coordinates are taken from the middle of the target leaf, in lengths `size` that none exceeds:
/// an error of 2^-24 there moves a vortex of core S by that much of its largest velocity over
/// sqrt(S), so cores must be wide,
///
///   S >= size^2 / 256,
///
/// for an error of 2^-24 times a few, relative to the sum of |gamma_j| / sqrt(S_j).
/// twin    p2p_kernel.hpp
struct SingleFrame {
  double x, y, size;
};

inline constexpr double widest_frame2 = 256.0;  // size^2 over the least S

class SinglePacked {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const SingleFrame& frame() const { return frame_; }
  [[nodiscard]] const float* x() const { return values_.data(); }
  [[nodiscard]] const float* y() const { return values_.data() + room_; }
  [[nodiscard]] const float* gamma() const { return values_.data() + 2 * room_; }
  [[nodiscard]] const float* core() const { return values_.data() + 3 * room_; }

  /// The sources of `packed`, whose cores are S_j, in another frame.
  template <class Pair>
  void assign(const PackedSources& packed, const SingleFrame& frame) {
    frame_ = frame;
    size_ = packed.size();
    if (room_ < padded(size_, single_count)) {
      room_ = padded(size_ + size_ / 2, single_count);
      values_.resize(4 * room_);
    }
    const double per_length = 1.0 / frame.size;
    const double per_area = per_length * per_length;
    float* to = values_.data();
    for (std::size_t j = 0; j < size_; ++j) {
      to[j] = static_cast<float>((packed.x()[j] - frame.x) * per_length);
      to[room_ + j] = static_cast<float>((packed.y()[j] - frame.y) * per_length);
      to[2 * room_ + j] = static_cast<float>(packed.gamma()[j]);
      to[3 * room_ + j] = Pair::packed_core_single(packed.core()[j] * per_area);
    }
    for (std::size_t j = size_; j < padded(size_, single_count); ++j) {
      to[j] = to[0], to[room_ + j] = to[room_], to[2 * room_ + j] = 0.0f;
      to[3 * room_ + j] = to[3 * room_];
    }
  }

 private:
  SingleFrame frame_{};
  std::size_t size_ = 0, room_ = 0;
  std::vector<float> values_;  // x, y, gamma, core, each `room_` long
};

template <class Pair, int rows>
inline void p2p_single_rows(const SinglePacked& sources, const NearTargets& targets,
                            std::size_t first) {
  const SingleFrame& frame = sources.frame();
  const double per_length = 1.0 / frame.size;
  Singles u[rows] = {}, v[rows] = {};
  float target_x[rows], target_y[rows], target_core[rows];
  for (int i = 0; i < rows; ++i) {
    target_x[i] = static_cast<float>((targets.x[first + i] - frame.x) * per_length);
    target_y[i] = static_cast<float>((targets.y[first + i] - frame.y) * per_length);
    target_core[i] = static_cast<float>(0.5 * targets.core[first + i] * per_length * per_length);
  }
  for (std::size_t j = 0; j < sources.size(); j += single_count) {
    const Singles x = load(sources.x() + j), y = load(sources.y() + j);
    Singles dx[rows], dy[rows], r2[rows], w[rows];
    for (int i = 0; i < rows; ++i) {
      dx[i] = target_x[i] - x;
      dy[i] = target_y[i] - y;
      r2[i] = dx[i] * dx[i] + (dy[i] * dy[i] + 1e-30f);
    }
    Pair::weigh(r2, load(sources.core() + j), target_core, load(sources.gamma() + j), w);
    for (int i = 0; i < rows; ++i) {
      u[i] -= w[i] * dy[i];
      v[i] += w[i] * dx[i];
    }
  }
  for (int i = 0; i < rows; ++i) {
    targets.u[first + i] += sum(u[i]) * per_length;
    targets.v[first + i] += sum(v[i]) * per_length;
  }
}

template <class Pair>
void p2p_single(const SinglePacked& sources, const NearTargets& targets) {
  if (sources.size() == 0) return;
  std::size_t i = 0;
  for (; i + 4 <= targets.size; i += 4) p2p_single_rows<Pair, 4>(sources, targets, i);
  switch (targets.size - i) {
    case 3:
      return p2p_single_rows<Pair, 3>(sources, targets, i);
    case 2:
      return p2p_single_rows<Pair, 2>(sources, targets, i);
    case 1:
      return p2p_single_rows<Pair, 1>(sources, targets, i);
    default:
      return;
  }
}

}  // namespace vortree::fmm
