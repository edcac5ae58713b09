#pragma once

#include <array>

#include "sph/operators/gather_kernel.hpp"
#include "tree/base/simd.hpp"

namespace vortree::sph {

/// Moving least squares in the plane, a particle a lane. Monomials X^a Y^b are numbered by degree
/// d = a + b, then by b, from degree 1 on:
///
///   number   0  1  2   3   4   5 ...
///            X  Y  XX  XY  YY  XXX ...
///
/// Of a fit of degree m only moments up to degree 2m matter,
///
///   M_ef = sum_j w_j p_e p_f = S(monomial e times monomial f).
constexpr int monomials(int degree) {
  return (degree + 1) * (degree + 2) / 2 - 1;
}
constexpr int degree_of(int number) {
  int degree = 1;
  while (number >= monomials(degree)) ++degree;
  return degree;
}
constexpr int power_of_y(int number) {
  return number - monomials(degree_of(number) - 1);
}
constexpr int product_of(int e, int f) {
  return monomials(degree_of(e) + degree_of(f) - 1) + power_of_y(e) + power_of_y(f);
}

/// All monomials up to a degree, each times `first`.
template <int degree>
inline std::array<Lanes, monomials(degree)> monomials_at(Lanes x, Lanes y, Lanes first) {
  std::array<Lanes, monomials(degree)> p;
  p[0] = first * x, p[1] = first * y;
  for (int d = 2, k = 2; d <= degree; ++d) {
    const int lower = monomials(d - 2);
    for (int b = 0; b < d; ++b, ++k) p[k] = p[lower + b] * x;
    p[k++] = p[lower + d - 1] * y;
  }
  return p;
}

/// The moment matrix's Cholesky factors, and the five rows of its inverse that make derivatives.
template <int degree>
class Fit {
 public:
  static constexpr int terms = monomials(degree);

  void add(Lanes x, Lanes y, Lanes weight) {
    const auto p = monomials_at<2 * degree>(x, y, weight);
    for (int k = 2; k < monomials(2 * degree); ++k) moments_[k] += p[k];
  }

  /// Lanes whose neighbors do not tell the terms apart: a pivot below `least` of its diagonal.
  LaneSet solve(double least) {
    Bits sound = Lanes{} < fill(1.0);
    for (int i = 0; i < terms; ++i)
      for (int j = 0; j <= i; ++j) {
        Lanes sum = moments_[product_of(i, j)];
        for (int k = 0; k < j; ++k) sum -= factor_[i][k] * factor_[j][k];
        if (i == j) {
          const Bits good = sum > least * moments_[product_of(i, i)];
          sound &= good;
          inverse_[i] = 1.0 / root(good ? sum : fill(1.0));
        } else {
          factor_[i][j] = sum * inverse_[j];
        }
      }
    for (int e = 0; e < 5; ++e) substitute(e);
    return ~where(sound) & first_lanes(lane_count);
  }

  /// The derivatives' weights of a neighbor, each without its scale.
  std::array<Lanes, 5> weights(Lanes x, Lanes y, Lanes weight) const {
    const auto p = monomials_at<degree>(x, y, weight);
    std::array<Lanes, 5> of{};
    for (int e = 0; e < 5; ++e)
      for (int k = 0; k < terms; ++k) of[e] += row_[e][k] * p[k];
    return of;
  }

 private:
  void substitute(int e) {
    std::array<Lanes, terms> y{};
    for (int i = e; i < terms; ++i) {
      Lanes sum = fill(i == e ? 1.0 : 0.0);
      for (int k = e; k < i; ++k) sum -= factor_[i][k] * y[k];
      y[i] = sum * inverse_[i];
    }
    for (int i = terms - 1; i >= 0; --i) {
      Lanes sum = y[i];
      for (int k = i + 1; k < terms; ++k) sum -= factor_[k][i] * row_[e][k];
      row_[e][i] = sum * inverse_[i];
    }
  }

  std::array<Lanes, monomials(2 * degree)> moments_{};
  std::array<std::array<Lanes, terms>, terms> factor_;
  std::array<Lanes, terms> inverse_;
  std::array<std::array<Lanes, terms>, 5> row_;
};

}  // namespace vortree::sph
