#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#ifdef __AVX512DQ__
#include <immintrin.h>
#endif

namespace vortree::fmm {

/// Eight doubles, or sixteen floats, that are worked on at once: the compilers' own vector types,
/// so that the operators + - * / < ?: act on all lanes and a product followed by a sum becomes one
/// fused instruction. On machines with narrower registers the compiler takes two or four of them.
inline constexpr int lane_count = 8;
using Lanes [[gnu::vector_size(64)]] = double;
using Bits [[gnu::vector_size(64)]] = std::int64_t;

inline constexpr int single_count = 16;
using Singles [[gnu::vector_size(64)]] = float;
using SingleBits [[gnu::vector_size(64)]] = std::int32_t;

inline Lanes load(const double* from) {
  Lanes a;
  std::memcpy(&a, from, sizeof a);
  return a;
}
inline Singles load(const float* from) {
  Singles a;
  std::memcpy(&a, from, sizeof a);
  return a;
}

inline void store(double* to, Lanes a) {
  std::memcpy(to, &a, sizeof a);
}
inline void store(float* to, Singles a) {
  std::memcpy(to, &a, sizeof a);
}

inline Lanes fill(double value) {
  return value - Lanes{};
}
inline Singles fill(float value) {
  return value - Singles{};
}

inline Lanes larger(Lanes a, Lanes b) {
  return a > b ? a : b;
}
inline Lanes smaller(Lanes a, Lanes b) {
  return a < b ? a : b;
}
inline Lanes magnitude(Lanes a) {
  return (Lanes)((Bits)a & INT64_MAX);
}

inline double largest(Lanes a) {
  double most = a[0];
  for (int i = 1; i < lane_count; ++i) most = most < a[i] ? a[i] : most;
  return most;
}

/// Sum over the lanes, always in the same order.
inline double sum(Lanes a) {
  return ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7]));
}

/// The first and the last eight of sixteen floats, as doubles.
inline Lanes low(Singles a) {
  return __builtin_convertvector(__builtin_shufflevector(a, a, 0, 1, 2, 3, 4, 5, 6, 7), Lanes);
}
inline Lanes high(Singles a) {
  return __builtin_convertvector(__builtin_shufflevector(a, a, 8, 9, 10, 11, 12, 13, 14, 15),
                                 Lanes);
}

inline double sum(Singles a) {
  return sum(low(a) + high(a));
}

/// n rounded up to whole vectors.
constexpr std::size_t padded(std::size_t n, std::size_t count = lane_count) {
  return (n + count - 1) / count * count;
}

/// Some of the lanes, one bit each.
using LaneSet = unsigned;

/// The first n lanes, at most all.
inline LaneSet first_lanes(std::size_t n) {
  return n >= lane_count ? 0xffu : (1u << n) - 1u;
}

#ifdef __AVX512DQ__

inline LaneSet where(Bits condition) {
  return _mm512_movepi64_mask((__m512i)condition);
}

inline Lanes load(const double* from, LaneSet lanes, double others = 0.0) {
  return (Lanes)_mm512_mask_loadu_pd((__m512d)fill(others), static_cast<__mmask8>(lanes), from);
}

/// Stores the chosen lanes next to each other; eight places must be writable.
inline void store_close(double* to, Lanes a, LaneSet lanes) {
  _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(lanes), (__m512d)a));
}

#else

inline LaneSet where(Bits condition) {
  LaneSet lanes = 0;
  for (int i = 0; i < lane_count; ++i) lanes |= condition[i] != 0 ? 1u << i : 0u;
  return lanes;
}

inline Lanes load(const double* from, LaneSet lanes, double others = 0.0) {
  Lanes a = fill(others);
  for (int i = 0; i < lane_count; ++i) {
    if (lanes >> i & 1u) a[i] = from[i];
  }
  return a;
}

inline void store_close(double* to, Lanes a, LaneSet lanes) {
  for (int i = 0; i < lane_count; ++i) {
    *to = a[i];
    to += lanes >> i & 1u;
  }
}

#endif

}  // namespace vortree::fmm
