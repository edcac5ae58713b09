#pragma once

#include <cstdint>
#include <cstring>
#include <iterator>

namespace vortree::fmm {

/// Eight doubles that are worked on at once: the compilers' own vector type, so that the operators
/// + - * / < ?: act on all lanes and a product followed by a sum becomes one fused instruction.
/// On machines with narrower registers the compiler takes two or four of them.
inline constexpr int lane_count = 8;
using Lanes [[gnu::vector_size(64)]] = double;
using Bits [[gnu::vector_size(64)]] = std::int64_t;

inline Lanes load(const double* from) {
  Lanes a;
  std::memcpy(&a, from, sizeof a);
  return a;
}

inline void store(double* to, Lanes a) {
  std::memcpy(to, &a, sizeof a);
}

inline Lanes fill(double value) {
  return value - Lanes{};
}

/// Sum over the lanes, always in the same order.
inline double sum(Lanes a) {
  return ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7]));
}

/// n rounded up to whole vectors.
constexpr std::size_t padded(std::size_t n) {
  return (n + lane_count - 1) / lane_count * lane_count;
}

}  // namespace vortree::fmm
