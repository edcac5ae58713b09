#pragma once

#include <cstddef>

#include "fmm/series/translation_kernel.hpp"
#include "fmm/tuning.hpp"
#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// Between points and the series of a cell on its lattice; lanes are points. The formulas are those
/// of translation_kernel.hpp. Points are given by t = (z - centre)/side.
///
///   P2M   c_k += sum_j gamma_j t_j^k
///   P2L   L_l -= sum_j gamma_j t_j^-(l+1)
///   L2P   side f = sum_l L_l t^l
///   M2P   side f = sum_k c_k t^-(k+1)
///
/// twin    specification.hpp

/// Points of a cell for a series, filled up with points at the centre without circulation.
template <class Number>
struct LatticePoints {
  static constexpr int n = VectorOf<Number>::count;
  alignas(64) Number x[points_a_series], y[points_a_series], gamma[points_a_series];
  int size = 0, vectors = 0;
};

/// Sums of gamma w^k, with w and the first term given as vectors, added to the series.
template <class Number, int rows>
inline void add_powers(typename VectorOf<Number>::Type (&wx)[rows],
                       typename VectorOf<Number>::Type (&wy)[rows],
                       typename VectorOf<Number>::Type (&re)[rows],
                       typename VectorOf<Number>::Type (&im)[rows], int padded, Number* series) {
  using Vector = typename VectorOf<Number>::Type;
  constexpr int n = VectorOf<Number>::count;
  for (int first = 0; first < padded; first += n) {
    Vector sum_re[n], sum_im[n];
    for (int k = 0; k < n; ++k) {
      sum_re[k] = re[0], sum_im[k] = im[0];
      for (int i = 1; i < rows; ++i) sum_re[k] += re[i], sum_im[k] += im[i];
      for (int i = 0; i < rows; ++i) {
        const Vector next = re[i] * wx[i] - im[i] * wy[i];
        im[i] = re[i] * wy[i] + im[i] * wx[i];
        re[i] = next;
      }
    }
    transpose<Number>(sum_re);
    transpose<Number>(sum_im);
    Vector total_re = sum_re[0], total_im = sum_im[0];
    for (int k = 1; k < n; ++k) total_re += sum_re[k], total_im += sum_im[k];
    store(series + first, load(series + first) + total_re);
    store(series + padded + first, load(series + padded + first) + total_im);
  }
}

template <class Number, int rows>
inline void p2m_rows(const Number* x, const Number* y, const Number* gamma, int padded,
                     Number* series) {
  using Vector = typename VectorOf<Number>::Type;
  constexpr int n = VectorOf<Number>::count;
  Vector wx[rows], wy[rows], re[rows], im[rows];
  for (int i = 0; i < rows; ++i) {
    wx[i] = load(x + n * i), wy[i] = load(y + n * i);
    re[i] = load(gamma + n * i), im[i] = Vector{};
  }
  add_powers<Number, rows>(wx, wy, re, im, padded, series);
}

template <class Number, int rows>
inline void p2l_rows(const Number* x, const Number* y, const Number* gamma, int padded,
                     Number* series) {
  using Vector = typename VectorOf<Number>::Type;
  constexpr int n = VectorOf<Number>::count;
  Vector wx[rows], wy[rows], re[rows], im[rows];
  for (int i = 0; i < rows; ++i) {
    const Vector px = load(x + n * i), py = load(y + n * i), g = load(gamma + n * i);
    const Vector inverse = 1 / (px * px + py * py);
    wx[i] = px * inverse, wy[i] = -py * inverse;
    re[i] = -g * wx[i], im[i] = -g * wy[i];
  }
  add_powers<Number, rows>(wx, wy, re, im, padded, series);
}

/// sum_k series_k w^k.
template <class Number, int rows>
inline void horner(const Number* series, int padded, int terms,
                   const typename VectorOf<Number>::Type (&wx)[rows],
                   const typename VectorOf<Number>::Type (&wy)[rows],
                   typename VectorOf<Number>::Type (&re)[rows],
                   typename VectorOf<Number>::Type (&im)[rows]) {
  using Vector = typename VectorOf<Number>::Type;
  for (int i = 0; i < rows; ++i) {
    re[i] = fill(series[terms - 1]);
    im[i] = fill(series[padded + terms - 1]);
  }
  for (int k = terms - 2; k >= 0; --k) {
    for (int i = 0; i < rows; ++i) {
      const Vector next = wx[i] * re[i] + (series[k] - wy[i] * im[i]);
      im[i] = wx[i] * im[i] + (series[padded + k] + wy[i] * re[i]);
      re[i] = next;
    }
  }
}

/// Adds side f: its imaginary part to u, its real part to v.
template <class Number, int rows>
inline void l2p_rows(const Number* series, int padded, int terms, const Number* x, const Number* y,
                     Number* u, Number* v) {
  using Vector = typename VectorOf<Number>::Type;
  constexpr int n = VectorOf<Number>::count;
  Vector wx[rows], wy[rows], re[rows], im[rows];
  for (int i = 0; i < rows; ++i) wx[i] = load(x + n * i), wy[i] = load(y + n * i);
  horner<Number, rows>(series, padded, terms, wx, wy, re, im);
  for (int i = 0; i < rows; ++i) {
    store(u + n * i, load(u + n * i) + im[i]);
    store(v + n * i, load(v + n * i) + re[i]);
  }
}

template <class Number, int rows>
inline void m2p_rows(const Number* series, int padded, int terms, const Number* x, const Number* y,
                     Number* u, Number* v) {
  using Vector = typename VectorOf<Number>::Type;
  constexpr int n = VectorOf<Number>::count;
  Vector wx[rows], wy[rows], re[rows], im[rows];
  for (int i = 0; i < rows; ++i) {
    const Vector px = load(x + n * i), py = load(y + n * i);
    const Vector inverse = 1 / (px * px + py * py);
    wx[i] = px * inverse, wy[i] = -py * inverse;
  }
  horner<Number, rows>(series, padded, terms, wx, wy, re, im);
  for (int i = 0; i < rows; ++i) {
    store(u + n * i, load(u + n * i) + (wx[i] * im[i] + wy[i] * re[i]));
    store(v + n * i, load(v + n * i) + (wx[i] * re[i] - wy[i] * im[i]));
  }
}

/// `act<rows>(first)` for up to four vectors at a time.
template <int n, class Act>
inline void by_rows(int vectors, Act act) {
  int first = 0;
  for (; first + 4 <= vectors; first += 4) act.template operator()<4>(n * first);
  switch (vectors - first) {
    case 3:
      return act.template operator()<3>(n * first);
    case 2:
      return act.template operator()<2>(n * first);
    case 1:
      return act.template operator()<1>(n * first);
    default:
      return;
  }
}

}  // namespace vortree::fmm
