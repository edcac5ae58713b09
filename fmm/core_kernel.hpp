#pragma once

#include <cmath>
#include <iterator>

#include "tree/lanes.hpp"

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

/// With n = round(-q log2 e) and f the remainder, |f| <= 1/2,
///   1 - exp(-q) = 1 - 2^n (1 + p) = (1 - 2^n) - 2^n p,   p = 2^f - 1,
/// where 1 - 2^n is exact and vanishes for n = 0, so that small q keep all their digits.
/// Beyond `largest` the result is 1 to the last bit and 2^n would leave the range.
///
/// Several vectors go side by side, step by step: one alone would wait for its own polynomial.
template <class Exp, class Vector, int rows>
inline void core(const Vector (&q)[rows], Vector (&result)[rows]) {
  using Rounding = RoundingOf<Vector>;
  using Number = typename Rounding::Number;
  using Integers = typename Rounding::Integers;
  constexpr Number log2e = static_cast<Number>(1.4426950408889634074);
  constexpr int degree = std::size(Exp::terms) - 1;
  const Vector limit = fill(Rounding::largest);
  Vector bounded[rows], shifted[rows], f[rows], p[rows];
  for (int i = 0; i < rows; ++i) bounded[i] = q[i] < limit ? q[i] : limit;
  for (int i = 0; i < rows; ++i) shifted[i] = Rounding::shifter - bounded[i] * log2e;
  for (int i = 0; i < rows; ++i) f[i] = (Rounding::shifter - shifted[i]) - bounded[i] * log2e;
  for (int i = 0; i < rows; ++i) p[i] = fill(static_cast<Number>(Exp::terms[degree]));
#pragma GCC unroll 16
  for (int k = degree - 1; k >= 0; --k) {
    for (int i = 0; i < rows; ++i) p[i] = p[i] * f[i] + static_cast<Number>(Exp::terms[k]);
  }
  for (int i = 0; i < rows; ++i) p[i] *= f[i];
  for (int i = 0; i < rows; ++i) {
    const Integers one = (Integers)fill(Number{1});
    const Vector power = (Vector)(((Integers)shifted[i] << Rounding::exponent_bits) + one);
    result[i] = (1 - power) - power * p[i];
  }
}

}  // namespace vortree::fmm
