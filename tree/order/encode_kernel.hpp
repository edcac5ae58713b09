#pragma once

#include <cstddef>
#include <cstdint>

#include "tree/base/simd.hpp"
#include "tree/order/morton.hpp"

/// Codes of many points, a register full at a time; the plain twin is the form for one point.
namespace vortree::tree::kernel {

/// One axis of a domain.
struct DomainAxis {
  double first, last, scale;

  [[nodiscard]] bool holds(double v) const { return (v >= first) & (v <= last); }

  /// Defined for any v, so that a whole pass may run before somebody looks for strays.
  [[nodiscard]] std::uint32_t cell(double v) const {
    const double q = (v - first) * scale;
    const double not_below = q > 0 ? q : 0;
    return static_cast<std::uint32_t>(
        static_cast<std::int32_t>(not_below < last_cell ? not_below : last_cell));
  }

  static constexpr double last_cell = 0x1p31 - 1;
};

/// Codes of n points, and how many of them lie outside.
[[nodiscard]] inline std::size_t plain_codes(const double* x, const double* y, std::size_t n,
                                             const DomainAxis& along_x, const DomainAxis& along_y,
                                             MortonKey mask, MortonKey* codes) {
  std::size_t strays = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool in_x = along_x.holds(x[i]), in_y = along_y.holds(y[i]);
    strays += static_cast<std::size_t>(!(in_x & in_y));
    codes[i] = encode({along_x.cell(x[i]), along_y.cell(y[i])}) & mask;
  }
  return strays;
}

#if defined(__AVX2__)

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512BW__)
inline __m256i truncated(Lanes q) {
  return _mm512_cvttpd_epi32((__m512d)q);
}
inline __m512i widened(__m256i v) {
  return _mm512_cvtepu32_epi64(v);
}
inline __m512i looked_up(__m512i table, __m512i at) {
  return _mm512_shuffle_epi8(table, at);
}
inline __m512i repeated(__m128i v) {
  return _mm512_broadcast_i32x4(v);
}
#else
inline __m128i truncated(Lanes q) {
  return _mm256_cvttpd_epi32((__m256d)q);
}
inline __m256i widened(__m128i v) {
  return _mm256_cvtepu32_epi64(v);
}
inline __m256i looked_up(__m256i table, __m256i at) {
  return _mm256_shuffle_epi8(table, at);
}
inline __m256i repeated(__m128i v) {
  return _mm256_broadcastsi128_si256(v);
}
#endif

using HalfWhole = decltype(truncated(Lanes{}));
using Whole = decltype(widened(HalfWhole{}));

/// spread_bits of every lane: each byte is doubled, and half a byte looked up for each of the two.
inline Bits spread_lanes(HalfWhole number) {
  const Whole twice = repeated(_mm_setr_epi8(0, 0, 1, 1, 2, 2, 3, 3, 8, 8, 9, 9, 10, 10, 11, 11));
  const Whole spread =
      repeated(_mm_setr_epi8(0, 1, 4, 5, 16, 17, 20, 21, 64, 65, 68, 69, 80, 81, 84, 85));
  const Bits bytes = (Bits)looked_up(widened(number), twice);
  const Bits low = bytes & 0x000f000f000f000f, high = bytes >> 4 & 0x0f000f000f000f00;
  return (Bits)looked_up(spread, (Whole)(low | high));
}

[[nodiscard]] inline std::size_t codes(const double* x, const double* y, std::size_t n,
                                       const DomainAxis& along_x, const DomainAxis& along_y,
                                       MortonKey mask, MortonKey* codes) {
  const auto cell = [](Lanes v, const DomainAxis& axis) {
    const Lanes q = (v - axis.first) * axis.scale;
    return truncated(smaller(larger(q, Lanes{}), fill(DomainAxis::last_cell)));
  };
  const auto outside = [](Lanes v, const DomainAxis& axis) {
    return ~((v >= axis.first) & (v <= axis.last));
  };
  Bits strays = {};  // minus one for each
  std::size_t i = 0;
  for (; i + lane_count <= n; i += lane_count) {
    const Lanes px = load(x + i), py = load(y + i);
    strays += (Bits)(outside(px, along_x) | outside(py, along_y));
    const Bits code = spread_lanes(cell(px, along_x)) | spread_lanes(cell(py, along_y)) << 1;
    const Bits kept = code & static_cast<std::int64_t>(mask);
    __builtin_memcpy(codes + i, &kept, sizeof kept);
  }
  std::size_t found = plain_codes(x + i, y + i, n - i, along_x, along_y, mask, codes + i);
  for (int lane = 0; lane < lane_count; ++lane) found -= static_cast<std::size_t>(strays[lane]);
  return found;
}

#else

[[nodiscard]] inline std::size_t codes(const double* x, const double* y, std::size_t n,
                                       const DomainAxis& along_x, const DomainAxis& along_y,
                                       MortonKey mask, MortonKey* codes) {
  return plain_codes(x, y, n, along_x, along_y, mask, codes);
}

#endif

}  // namespace vortree::tree::kernel
