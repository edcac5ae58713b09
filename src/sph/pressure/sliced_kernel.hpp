#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "sph/pressure/sliced_rows.hpp"
#include "tree/base/simd.hpp"

namespace vortree::sph::kernel {

/// Floats in whole slices, and two side by side for each row.
using SlicedColumn = std::vector<float>;
using SlicedPairs = std::vector<float>;

/// Slices beyond which threads share: fewer are done before the others wake.
inline constexpr std::size_t slices_worth_sharing = 512,
                             rows_worth_sharing = slices_worth_sharing * SlicedRows::lanes;

/// x at the places of a register.
inline Singles gather(const float* x, SingleBits places) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  return (Singles)_mm512_i32gather_ps((__m512i)places, x, 4);
#elif defined(__AVX2__)
  return (Singles)_mm256_i32gather_ps(x, (__m256i)places, 4);
#else
  Singles a;
  for (int i = 0; i < single_count; ++i) a[i] = x[places[i]];
  return a;
#endif
}

inline Lanes gather(const double* x, const std::int32_t* places) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  return (Lanes)_mm512_i32gather_pd(_mm256_loadu_si256((const __m256i*)places), x, 8);
#elif defined(__AVX2__)
  return (Lanes)_mm256_i32gather_pd(x, _mm_loadu_si128((const __m128i*)places), 8);
#else
  Lanes a;
  for (int i = 0; i < lane_count; ++i) a[i] = x[places[i]];
  return a;
#endif
}

/// Pairs of floats at so many places as a register has.
inline Singles gather_pairs(const float* x, const std::int32_t* places) {
#if defined(__AVX2__)
  return (Singles)gather(reinterpret_cast<const double*>(x), places);
#else
  Singles a;
  for (int i = 0; i < lane_count; ++i)
    a[2 * i] = x[2 * places[i]], a[2 * i + 1] = x[2 * places[i] + 1];
  return a;
#endif
}

/// Each of half a register's floats twice.
inline Singles doubled(const float* from) {
  HalfSingles a;
  std::memcpy(&a, from, sizeof a);
  return [&]<int... lane>(std::integer_sequence<int, lane...>) {
    return __builtin_shufflevector(a, a, (lane / 2)...);
  }
  (std::make_integer_sequence<int, single_count>{});
}

inline constexpr std::size_t slice_parts = SlicedRows::lanes / single_count;  // registers

/// Shows sums over the rows of all slices, sum_j a_ij x_j, a register of them at a time: use(i,
/// sums) for rows i, i + 1, ... Of differences: sum_j a_ij (x_j - x_i).
template <bool of_differences>
inline void sum_slice(const SlicedRows& a, std::size_t slice, const float* x, const auto& use) {
  Singles sums[slice_parts] = {}, own[slice_parts] = {};
  for (std::size_t part = 0; of_differences && part < slice_parts; ++part)
    own[part] = load(x + slice * SlicedRows::lanes + part * single_count);
  const std::size_t last = a.begin[slice + 1];
  for (std::size_t k = a.begin[slice]; k < last; ++k)
    for (std::size_t part = 0; part < slice_parts; ++part) {
      const std::size_t at = k * SlicedRows::lanes + part * single_count;
      const Singles there = gather(x, load(a.index.data() + at));
      sums[part] += load(a.value.data() + at) * (of_differences ? there - own[part] : there);
    }
  for (std::size_t part = 0; part < slice_parts; ++part)
    use(slice * SlicedRows::lanes + part * single_count, sums[part]);
}

template <bool of_differences = false>
inline void for_slices(const SlicedRows& a, const SlicedColumn& x, const auto& use) {
#pragma omp parallel for schedule(static) if (a.slices() > slices_worth_sharing)
  for (std::size_t slice = 0; slice < a.slices(); ++slice)
    sum_slice<of_differences>(a, slice, x.data(), use);
}
inline void for_slices_of_differences(const SlicedRows& a, const SlicedColumn& x, const auto& use) {
  for_slices<true>(a, x, use);
}

/// The same of differences for pairs side by side: use(i, sums) for rows i, i + 1, ..., as many
/// as a register has pairs.
inline void for_slices_of_pairs(const SlicedRows& a, const float* x, const auto& use) {
#pragma omp parallel for schedule(static) if (a.slices() > slices_worth_sharing)
  for (std::size_t slice = 0; slice < a.slices(); ++slice)
    for (std::size_t from = 0; from < SlicedRows::lanes; from += lane_count) {
      const std::size_t i = slice * SlicedRows::lanes + from, last = a.begin[slice + 1];
      const Singles own = load(x + 2 * i);
      Singles sums{};
      for (std::size_t k = a.begin[slice]; k < last; ++k) {
        const std::size_t at = k * SlicedRows::lanes + from;
        sums += doubled(a.value.data() + at) * (gather_pairs(x, a.index.data() + at) - own);
      }
      use(i, sums);
    }
}

/// A x in doubles, as use(i, sums) for rows i, i + 1, ..., as many as a register has. Of
/// differences: sum_j a_ij (x_j - x_i).
template <bool of_differences>
inline void for_slices(const SlicedDoubles& a, const double* x, const auto& use) {
#pragma omp parallel for schedule(static) if (a.slices() > slices_worth_sharing)
  for (std::size_t slice = 0; slice < a.slices(); ++slice)
    for (std::size_t from = 0; from < SlicedRows::lanes; from += lane_count) {
      const std::size_t last = a.begin[slice + 1] * SlicedRows::lanes;
      std::size_t at = a.begin[slice] * SlicedRows::lanes + from;
      const Lanes own = of_differences ? gather(x, a.index.data() + at) : Lanes{};
      Lanes sums{};
      for (; at < last; at += SlicedRows::lanes)
        sums += load(a.value.data() + at) * (gather(x, a.index.data() + at) - own);
      use(slice * SlicedRows::lanes + from, sums);
    }
}

/// What is to be known of a register of rows: their diagonals, the sums of magnitudes beside them,
/// and the largest value beside that has the other sign, as a magnitude.
struct RowsInShort {
  Singles diagonal{}, beside{}, largest{};
};

inline RowsInShort rows_in_short(const SlicedRows& a, std::size_t slice, std::size_t part) {
  RowsInShort made;
  Singles most{}, least{};
  SingleBits own;
  for (int i = 0; i < single_count; ++i)
    own[i] = static_cast<std::int32_t>(slice * SlicedRows::lanes + part * single_count) + i;
  const std::size_t last = a.begin[slice + 1];
  for (std::size_t k = a.begin[slice]; k < last; ++k) {
    const std::size_t at = k * SlicedRows::lanes + part * single_count;
    const Singles value = load(a.value.data() + at);
    const SingleBits is_own = load(a.index.data() + at) == own;
    const Singles other = select(is_own, Singles{}, value);
    made.diagonal += select(is_own, value, Singles{});
    made.beside += magnitude(other);
    most = larger(most, other), least = smaller(least, other);
  }
  made.largest = select(made.diagonal < Singles{}, most, -least);
  return made;
}

}  // namespace vortree::sph::kernel
