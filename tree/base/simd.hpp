#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#ifdef __AVX__
// GCC 12 takes the undefined lanes of its own AVX-512 intrinsics for a mistake.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <immintrin.h>
#pragma GCC diagnostic pop
#endif

namespace vortree {

/// One register full of doubles, or of floats, that are worked on at once: the compilers' own
/// vector types, so that the operators + - * / < ?: act on all lanes and a product followed by a
/// sum becomes one fused instruction. Types wider than the machine's registers would live in
/// memory.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
inline constexpr int register_bytes = 64, registers = 32;
#elif defined(__AVX__)
inline constexpr int register_bytes = 32, registers = 16;
#else
inline constexpr int register_bytes = 16, registers = 16;
#endif

inline constexpr int lane_count = register_bytes / 8;
using Lanes [[gnu::vector_size(register_bytes)]] = double;
using Bits = decltype(Lanes{} < Lanes{});  // whole numbers of 64 bits, under the compiler's name

inline constexpr int single_count = register_bytes / 4;
using Singles [[gnu::vector_size(register_bytes)]] = float;
using SingleBits [[gnu::vector_size(register_bytes)]] = std::int32_t;

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

inline SingleBits load(const std::int32_t* from) {
  SingleBits a;
  std::memcpy(&a, from, sizeof a);
  return a;
}

inline void store(double* to, Lanes a) {
  std::memcpy(to, &a, sizeof a);
}
inline void store(float* to, Singles a) {
  std::memcpy(to, &a, sizeof a);
}
inline void store(std::int32_t* to, SingleBits a) {
  std::memcpy(to, &a, sizeof a);
}

inline Lanes fill(double value) {
  return value - Lanes{};
}
inline Singles fill(float value) {
  return value - Singles{};
}

/// a > b ? a : b and a < b ? a : b.
inline Lanes larger(Lanes a, Lanes b) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  return (Lanes)_mm512_max_pd((__m512d)a, (__m512d)b);
#elif defined(__AVX__)
  return (Lanes)_mm256_max_pd((__m256d)a, (__m256d)b);
#else
  return a > b ? a : b;
#endif
}
inline Lanes smaller(Lanes a, Lanes b) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  return (Lanes)_mm512_min_pd((__m512d)a, (__m512d)b);
#elif defined(__AVX__)
  return (Lanes)_mm256_min_pd((__m256d)a, (__m256d)b);
#else
  return a < b ? a : b;
#endif
}
inline Singles larger(Singles a, Singles b) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  return (Singles)_mm512_max_ps((__m512)a, (__m512)b);
#elif defined(__AVX__)
  return (Singles)_mm256_max_ps((__m256)a, (__m256)b);
#else
  return a > b ? a : b;
#endif
}
inline Singles smaller(Singles a, Singles b) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  return (Singles)_mm512_min_ps((__m512)a, (__m512)b);
#elif defined(__AVX__)
  return (Singles)_mm256_min_ps((__m256)a, (__m256)b);
#else
  return a < b ? a : b;
#endif
}
inline SingleBits smaller(SingleBits a, SingleBits b) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  return (SingleBits)_mm512_min_epi32((__m512i)a, (__m512i)b);
#elif defined(__AVX2__)
  return (SingleBits)_mm256_min_epi32((__m256i)a, (__m256i)b);
#else
  return a < b ? a : b;
#endif
}
inline Lanes magnitude(Lanes a) {
  return (Lanes)((Bits)a & INT64_MAX);
}
inline Singles magnitude(Singles a) {
  return (Singles)((SingleBits)a & INT32_MAX);
}

/// condition ? a : b, without a turn of the condition that compilers put before it.
inline Singles select(SingleBits condition, Singles a, Singles b) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  return (Singles)_mm512_mask_blend_ps(_mm512_movepi32_mask((__m512i)condition), (__m512)b,
                                       (__m512)a);
#elif defined(__AVX__)
  return (Singles)_mm256_blendv_ps((__m256)b, (__m256)a, (__m256)condition);
#else
  return condition ? a : b;
#endif
}

inline double largest(Lanes a) {
  double most = a[0];
  for (int i = 1; i < lane_count; ++i) most = most < a[i] ? a[i] : most;
  return most;
}

/// Sum over the lanes, always in the same order.
inline double sum(Lanes a) {
  double part[lane_count];
  store(part, a);
  for (int width = lane_count / 2; width > 0; width /= 2) {
    for (int i = 0; i < width; ++i) part[i] += part[i + width];
  }
  return part[0];
}

/// The first and the last half of some floats, as doubles.
using HalfSingles [[gnu::vector_size(register_bytes / 2)]] = float;
inline Lanes low(Singles a) {
  return [&]<int... lane>(std::integer_sequence<int, lane...>) {
    return __builtin_convertvector(__builtin_shufflevector(a, a, lane...), Lanes);
  }
  (std::make_integer_sequence<int, lane_count>{});
}
inline Lanes high(Singles a) {
  return [&]<int... lane>(std::integer_sequence<int, lane...>) {
    return __builtin_convertvector(__builtin_shufflevector(a, a, (lane + lane_count)...), Lanes);
  }
  (std::make_integer_sequence<int, lane_count>{});
}

/// Two vectors of doubles as one of floats.
inline Singles narrowed(Lanes first, Lanes second) {
  const HalfSingles a = __builtin_convertvector(first, HalfSingles);
  const HalfSingles b = __builtin_convertvector(second, HalfSingles);
  return [&]<int... lane>(std::integer_sequence<int, lane...>) {
    return __builtin_shufflevector(a, b, lane...);
  }
  (std::make_integer_sequence<int, single_count>{});
}

/// Two vectors of doubles as one of whole numbers, the nearest ones.
inline SingleBits rounded(Lanes first, Lanes second) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  const __m512i low = _mm512_castsi256_si512(_mm512_cvtpd_epi32((__m512d)first));
  return (SingleBits)_mm512_inserti64x4(low, _mm512_cvtpd_epi32((__m512d)second), 1);
#elif defined(__AVX2__)
  return (SingleBits)_mm256_set_m128i(_mm256_cvtpd_epi32((__m256d)second),
                                      _mm256_cvtpd_epi32((__m256d)first));
#else
  SingleBits a;
  for (int i = 0; i < lane_count; ++i) {
    a[i] = static_cast<std::int32_t>(__builtin_lrint(first[i]));
    a[i + lane_count] = static_cast<std::int32_t>(__builtin_lrint(second[i]));
  }
  return a;
#endif
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
  return n >= lane_count ? (1u << lane_count) - 1u : (1u << n) - 1u;
}

#if defined(__AVX512F__) && defined(__AVX512DQ__)

inline LaneSet where(Bits condition) {
  return _mm512_movepi64_mask((__m512i)condition);
}

inline LaneSet where(SingleBits condition) {
  return _mm512_movepi32_mask((__m512i)condition);
}

inline Lanes load(const double* from, LaneSet lanes, double others = 0.0) {
  return (Lanes)_mm512_mask_loadu_pd((__m512d)fill(others), static_cast<__mmask8>(lanes), from);
}

/// Stores the chosen lanes next to each other; places for all must be writable.
inline void store_close(double* to, Lanes a, LaneSet lanes) {
  _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(lanes), (__m512d)a));
}

#elif defined(__AVX2__)

inline LaneSet where(Bits condition) {
  return static_cast<LaneSet>(_mm256_movemask_pd((__m256d)condition));
}

inline LaneSet where(SingleBits condition) {
  return static_cast<LaneSet>(_mm256_movemask_ps((__m256)condition));
}

inline Lanes load(const double* from, LaneSet lanes, double others = 0.0) {
  const Bits bit = {1, 2, 4, 8};
  const Bits chosen = (bit & static_cast<std::int64_t>(lanes)) != 0;
  const Lanes some = (Lanes)_mm256_maskload_pd(from, (__m256i)chosen);
  return chosen ? some : fill(others);
}

/// Stores the chosen lanes next to each other; places for all must be writable.
inline void store_close(double* to, Lanes a, LaneSet lanes) {
  struct Moves {
    alignas(32) std::int32_t half[16][8];
  };
  static constexpr Moves moves = [] {
    Moves made{};
    for (unsigned set = 0; set < 16; ++set) {
      for (int lane = 0, next = 0; lane < 4; ++lane) {
        if ((set >> lane & 1u) == 0) continue;
        made.half[set][2 * next] = 2 * lane, made.half[set][2 * next + 1] = 2 * lane + 1;
        ++next;
      }
    }
    return made;
  }();
  const __m256i move = _mm256_load_si256(reinterpret_cast<const __m256i*>(moves.half[lanes]));
  const __m256i close = _mm256_permutevar8x32_epi32((__m256i)a, move);
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), close);
}

#else

inline LaneSet where(Bits condition) {
  LaneSet lanes = 0;
  for (int i = 0; i < lane_count; ++i) lanes |= condition[i] != 0 ? 1u << i : 0u;
  return lanes;
}

inline LaneSet where(SingleBits condition) {
  LaneSet lanes = 0;
  for (int i = 0; i < single_count; ++i) lanes |= condition[i] != 0 ? 1u << i : 0u;
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

}  // namespace vortree
