#pragma once

#include <bit>
#include <cmath>
#include <iterator>

#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// What a Gaussian core leaves of a vortex at q = r^2/S:
///
///   core(q) = 1 - exp(-q),   q >= 0
///
/// error   relative, for every q: no digits are lost near q = 0.
///         4e-16 with the fine polynomial, 1.1e-8 with the coarse one, 2e-7 in floats
/// twin    core_plain
inline double core_plain(double q) {
  return -std::expm1(-q);
}

/// Minimax polynomials of (2^f - 1)/f on [-1/2, 1/2], the least relative error for their degree.
struct FineExp {  // 1.8e-17
  static constexpr double terms[] = {
      6.9314718055994531120e-1, 2.4022650695910097883e-1, 5.5504108664821237568e-2,
      9.6181291076070689874e-3, 1.3333558146531272784e-3, 1.5403530441475395319e-4,
      1.5252733701654778219e-5, 1.3215442727261362020e-6, 1.0178121082581965608e-7,
      7.0725611388635676243e-9, 4.4455738978280086145e-10};
};
struct CoarseExp {  // 1.1e-8
  static constexpr double terms[] = {6.9314718792543951169e-1, 2.4022649793603892776e-1,
                                     5.5503574370441067509e-2, 9.6182377458540407092e-3,
                                     1.3390734496650766038e-3, 1.5403434337111806768e-4};
};

/// 2^n beside a rounded n: `shifter` added to a number rounds it to an integer held by the low
/// bits, which `exponent_bits` moves into the exponent.
template <class Vector>
struct RoundingOf;
template <>
struct RoundingOf<Lanes> {
  using Number = double;
  using Integers = Bits;
  static constexpr double shifter = 0x1.8p52, largest = 700.0;
  static constexpr int exponent_bits = 52;
};
template <>
struct RoundingOf<Singles> {
  using Number = float;
  using Integers = SingleBits;
  static constexpr float shifter = 0x1.8p23f, largest = 80.0f;
  static constexpr int exponent_bits = 23;
};

/// sum_k terms[first + k] f^k for k < count, by halves (Estrin): the halves do not wait for each
/// other. power[i] = f^(2^i).
template <class Exp, int first, int count, class Vector>
inline Vector by_halves(const Vector* power) {
  using Number = typename RoundingOf<Vector>::Number;
  if constexpr (count == 1) {
    return fill(static_cast<Number>(Exp::terms[first]));
  } else {
    constexpr int level = std::bit_width(static_cast<unsigned>(count - 1)) - 1, half = 1 << level;
    return by_halves<Exp, first + half, count - half>(power) * power[level] +
           by_halves<Exp, first, half>(power);
  }
}

/// With n = round(-q log2 e) and f the remainder, |f| <= 1/2,
///   1 - exp(-q) = 1 - 2^n (1 + p) = (1 - 2^n) - 2^n p,   p = 2^f - 1,
/// where 1 - 2^n is exact and vanishes for n = 0, so that small q keep all their digits.
/// Beyond `largest` the result is 1 to the last bit and 2^n would leave the range.

template <class Exp, class Vector>
inline Vector core(Vector q) {
  using Rounding = RoundingOf<Vector>;
  using Number = typename Rounding::Number;
  using Integers = typename Rounding::Integers;
  constexpr Number log2e = static_cast<Number>(1.4426950408889634074);
  const Vector bounded = smaller(q, fill(Rounding::largest));
  const Vector shifted = Rounding::shifter - bounded * log2e;
  const Vector f = (Rounding::shifter - shifted) - bounded * log2e;
  const Vector f2 = f * f, f4 = f2 * f2;
  const Vector powers[] = {f, f2, f4, f4 * f4};
  const Vector p = by_halves<Exp, 0, std::size(Exp::terms)>(powers) * f;
  const Integers one = (Integers)fill(Number{1});
  const Vector power = (Vector)(((Integers)shifted << Rounding::exponent_bits) + one);
  return (1 - power) - power * p;
}

/// Several vectors side by side.
template <class Exp, class Vector, int rows>
inline void core(const Vector (&q)[rows], Vector (&result)[rows]) {
  for (int i = 0; i < rows; ++i) result[i] = core<Exp>(q[i]);
}

}  // namespace vortree::fmm
