#pragma once

#include <cstddef>

#include "fmm/geometry/deep_tree.hpp"
#include "fmm/series/multipole_kernel.hpp"
#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// A multipole or local expansion as it is stored, and where it stands: t = (z - centre)/side.
///
///   multipole         f = (1/side) sum_k c_k t^-(k+1)
///   local expansion   f = (1/side) sum_l L_l t^l
template <class Number>
struct SeriesView {
  const Number *re, *im;
  int terms;
};

/// sum_k a_k w^k: a derivative or an integral of a series above, its outer power of w taken out.
struct PowerSeries {
  double re[most_terms], im[most_terms];
  int terms = 0;

  template <class Number>
  void add(const SeriesView<Number>& from, int k, double factor) {
    re[terms] = factor * static_cast<double>(from.re[k]);
    im[terms] = factor * static_cast<double>(from.im[k]);
    ++terms;
  }
};

/// f' of a multipole is (1/side^2) w^2 times this, w = 1/t.
template <class Number>
PowerSeries multipole_slope(const SeriesView<Number>& multipole) {
  PowerSeries slope;
  for (int k = 0; k < multipole.terms; ++k) slope.add(multipole, k, -(k + 1));
  return slope;
}

/// f' of a local expansion is (1/side^2) times this, w = t.
template <class Number>
PowerSeries local_slope(const SeriesView<Number>& local) {
  PowerSeries slope;
  for (int l = 1; l < local.terms; ++l) slope.add(local, l, l);
  return slope;
}

/// The integral of f of a multipole is c_0 log(z - centre) plus w times this, w = 1/t.
template <class Number>
PowerSeries multipole_integral(const SeriesView<Number>& multipole) {
  PowerSeries integral;
  for (int k = 1; k < multipole.terms; ++k) integral.add(multipole, k, -1.0 / k);
  return integral;
}

/// The integral of f of a local expansion, from the centre on, is t times this, w = t.
template <class Number>
PowerSeries local_integral(const SeriesView<Number>& local) {
  PowerSeries integral;
  for (int l = 0; l < local.terms; ++l) integral.add(local, l, 1.0 / (l + 1));
  return integral;
}

/// Complex numbers, a vector of them.
struct Complexes {
  Lanes re, im;
};

inline Complexes operator*(const Complexes& a, const Complexes& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

/// 1/t.
inline Complexes reciprocal(const Complexes& t) {
  const Lanes inverse = 1.0 / (t.re * t.re + t.im * t.im);
  return {t.re * inverse, -t.im * inverse};
}

/// sum_k a_k w^k at several vectors of places, by Horner's rule.
template <int rows>
inline void sum_powers(const PowerSeries& a, const Complexes (&w)[rows], Complexes (&sum)[rows]) {
  for (int i = 0; i < rows; ++i) sum[i] = Complexes{Lanes{}, Lanes{}};
  for (int k = a.terms - 1; k >= 0; --k) {
    for (int i = 0; i < rows; ++i) {
      const Lanes re = w[i].re * sum[i].re + (a.re[k] - w[i].im * sum[i].im);
      sum[i].im = w[i].re * sum[i].im + (a.im[k] + w[i].im * sum[i].re);
      sum[i].re = re;
    }
  }
}

}  // namespace vortree::fmm
