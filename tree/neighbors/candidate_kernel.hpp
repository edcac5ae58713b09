#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "tree/base/simd.hpp"
#include "tree/neighbors/pair_rule.hpp"

/// Distance tests of one particle against many, a register full of floats at a time, and lists of
/// who passed. Plain twins: tests/tree/neighbors/candidate_kernel.cpp.
///
/// Positions are floats relative to a place nearby, so that a test is wrong only by some 2^-20 of
/// its threshold; who is nearer to it than that is told, and decided in doubles by others. So the
/// lists are exact, though nearly all tests are made in floats.
namespace vortree::tree::kernel {

/// Who of a register's lanes passed, one bit each.
using Hits = std::conditional_t<(single_count > 8), std::uint16_t, std::uint8_t>;

/// What is in doubt: |threshold - d2| <= doubt (threshold + h2), h the largest coordinate of the
/// particle tested. Positions as floats are off by 2^-24 of themselves (and 2^-51 from doubles):
/// those of the other by at most 2^-24 (d + h). So d is off by less than 2^-23 (d + h), each axis,
/// d2 by less than 2^-22 (1.5 d2 + h2), and, with its own operations, by 2^-22 (2 d2 + h2); the
/// threshold by 2^-22 of itself. Where d2 is near the threshold that is less than 2^-20 of
/// threshold + h2.
inline constexpr float doubt = 0x1p-19f;

/// What a pair rule keeps of each reach r: r^2 or r/2.
template <PairRule rule>
[[nodiscard]] constexpr float reach_term(float r) {
  return rule == PairRule::mean ? 0.5f * r : r * r;
}

inline constexpr Hits every_lane = static_cast<Hits>((std::uint32_t{1} << single_count) - 1);

[[nodiscard]] inline Hits first_singles(std::size_t n) {
  return n >= single_count ? every_lane : static_cast<Hits>((1u << n) - 1u);
}

#if defined(__AVX512F__) && defined(__AVX512DQ__)

inline Singles joined(HalfSingles a, HalfSingles b) {
  return (Singles)_mm512_insertf32x8(_mm512_castps256_ps512((__m256)a), (__m256)b, 1);
}
inline Hits less(Singles a, Singles b) {
  return _mm512_cmp_ps_mask((__m512)a, (__m512)b, _CMP_LT_OQ);
}
/// Not a > b: true for infinities of one sign and for NaNs.
inline Hits not_above(Singles a, Singles b) {
  return _mm512_cmp_ps_mask((__m512)a, (__m512)b, _CMP_NGT_UQ);
}
inline void store_close(float* to, Singles a, Hits lanes) {
  _mm512_storeu_ps(to, _mm512_maskz_compress_ps(lanes, (__m512)a));
}
inline void store_close(std::int32_t* to, SingleBits a, Hits lanes) {
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(lanes, (__m512i)a));
}

#elif defined(__AVX2__)

inline Singles joined(HalfSingles a, HalfSingles b) {
  return (Singles)_mm256_set_m128((__m128)b, (__m128)a);
}
inline Hits less(Singles a, Singles b) {
  return static_cast<Hits>(_mm256_movemask_ps(_mm256_cmp_ps((__m256)a, (__m256)b, _CMP_LT_OQ)));
}
inline Hits not_above(Singles a, Singles b) {
  return static_cast<Hits>(_mm256_movemask_ps(_mm256_cmp_ps((__m256)a, (__m256)b, _CMP_NGT_UQ)));
}

// For every set of lanes, which lane goes where.
struct Moves {
  alignas(64) std::uint8_t lane[256][8];
};
inline constexpr Moves moves = [] {
  Moves made{};
  for (unsigned set = 0; set < 256; ++set) {
    for (int lane = 0, next = 0; lane < 8; ++lane) {
      if (set >> lane & 1u) made.lane[set][next++] = static_cast<std::uint8_t>(lane);
    }
  }
  return made;
}();
inline __m256i move_of(Hits lanes) {
  return _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(moves.lane[lanes])));
}
inline void store_close(float* to, Singles a, Hits lanes) {
  _mm256_storeu_ps(to, _mm256_permutevar8x32_ps((__m256)a, move_of(lanes)));
}
inline void store_close(std::int32_t* to, SingleBits a, Hits lanes) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                      _mm256_permutevar8x32_epi32((__m256i)a, move_of(lanes)));
}

#else

inline Singles joined(HalfSingles a, HalfSingles b) {
  Singles all;
  std::memcpy(&all, &a, sizeof a);
  std::memcpy(reinterpret_cast<char*>(&all) + sizeof a, &b, sizeof b);
  return all;
}
inline Hits less(Singles a, Singles b) {
  const SingleBits condition = a < b;
  Hits lanes = 0;
  for (int i = 0; i < single_count; ++i) lanes |= condition[i] != 0 ? 1u << i : 0u;
  return lanes;
}
inline Hits not_above(Singles a, Singles b) {
  const SingleBits condition = a > b;
  Hits lanes = 0;
  for (int i = 0; i < single_count; ++i) lanes |= condition[i] == 0 ? 1u << i : 0u;
  return lanes;
}
inline void store_close(float* to, Singles a, Hits lanes) {
  for (int i = 0; i < single_count; ++i) {
    *to = a[i];
    to += lanes >> i & 1u;
  }
}
inline void store_close(std::int32_t* to, SingleBits a, Hits lanes) {
  for (int i = 0; i < single_count; ++i) {
    *to = a[i];
    to += lanes >> i & 1u;
  }
}

#endif

/// (from - origin) scale for a register full of doubles, as floats.
inline Singles near_floats(const double* from, double origin, double scale) {
  const Lanes a = (load(from) - origin) * scale;
  const Lanes b = (load(from + lane_count) - origin) * scale;
  return joined(__builtin_convertvector(a, HalfSingles), __builtin_convertvector(b, HalfSingles));
}

/// Which of a register full of floats' many doubles are above 0.
inline Hits positive(const double* values) {
  unsigned lanes = 0;
  for (int i = 0; i < single_count; ++i) lanes |= static_cast<unsigned>(values[i] > 0) << i;
  return static_cast<Hits>(lanes);
}

/// The square of a pair's reach, from both reach terms.
template <PairRule rule>
inline Singles threshold(Singles own, Singles other) {
  if constexpr (rule == PairRule::max) return larger(own, other);
  if constexpr (rule == PairRule::mean) return (own + other) * (own + other);
  return own;
}

/// Candidates that many particles are tested against: positions and reach terms, in whole
/// registers.
struct CandidateColumns {
  const float *u, *v, *reach;
};

/// A particle that is tested against them.
struct Seeker {
  float u, v, reach;
};

/// How many candidates passed for each seeker, and whether no pair was in doubt:
/// |threshold - d2| > doubt threshold + slack for all.
template <std::size_t count>
struct Tested {
  std::array<std::int64_t, count> hits;
  bool sure;
};

/// Tests some particles against the registers first..last - 1 of candidates, each of which is
/// loaded once for all of them. A set of lanes for each register goes to hits[0], ...: those of the
/// first particle, then those of the next.
template <PairRule rule, std::size_t count>
inline Tested<count> test(CandidateColumns all, std::size_t first, std::size_t last,
                          const std::array<Seeker, count>& seekers, float slack, Hits* hits) {
  const Singles zero{};
  Singles u[count], v[count], own[count], clearance = fill(3e38f);
  std::array<std::int64_t, count> passed{};
  for (std::size_t s = 0; s < count; ++s) {
    u[s] = fill(seekers[s].u), v[s] = fill(seekers[s].v), own[s] = fill(seekers[s].reach);
  }
  for (std::size_t k = first; k < last; ++k, ++hits) {
    const Singles to_u = load(all.u + k * single_count), to_v = load(all.v + k * single_count);
    const Singles other = rule == PairRule::own ? zero : load(all.reach + k * single_count);
    for (std::size_t s = 0; s < count; ++s) {
      const Singles du = to_u - u[s], dv = to_v - v[s];
      const Singles limit = threshold<rule>(own[s], other);
      const Singles gap = limit - du * du - dv * dv;
      const unsigned inside = less(zero, gap);
      hits[s * (last - first)] = static_cast<Hits>(inside);
      passed[s] += std::popcount(inside);
      clearance = smaller(clearance, magnitude(gap) - limit * doubt);
    }
  }
  return {passed, less(fill(slack), clearance) == every_lane};
}

/// Those of the candidates `index` that were hit, one after the other; returns their end. A
/// register beyond it is overwritten.
inline std::int32_t* expand(const Hits* hits, std::size_t registers, const std::int32_t* index,
                            std::int32_t* to) {
  std::size_t k = 0;
  for (; k + 2 <= registers; k += 2) {
    const Hits lanes = hits[k], next = hits[k + 1];
    store_close(to, load(index + k * single_count), lanes);
    to += std::popcount(lanes);
    store_close(to, load(index + (k + 1) * single_count), next);
    to += std::popcount(next);
  }
  if (k == registers) return to;
  store_close(to, load(index + k * single_count), hits[k]);
  return to + std::popcount(hits[k]);
}

/// Copies n numbers, and touches nothing beyond them. From `from` on a whole register is readable.
/// Four registers at a time, the last ones again where there are fewer: how many is not foreseen.
inline void copy_exactly(const std::int32_t* from, std::size_t n, std::int32_t* to) {
  if (n < single_count) {
    for (std::size_t i = 0; i < n; ++i) to[i] = from[i];
    return;
  }
  const std::size_t last = n - single_count;
  for (std::size_t i = 0; i < n; i += 4 * single_count) {
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t at = std::min(i + k * single_count, last);
      store(to + at, load(from + at));
    }
  }
}

}  // namespace vortree::tree::kernel
