#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// M2M, M2L and L2L between cells of one lattice, a vector of families at once: lane i of every
/// number belongs to family i. Number is double or float.
///
/// With t = (z - centre)/side in every cell,
///   multipole         c_k = sum_j gamma_j t_j^k
///   far field         f(z) = sum_j gamma_j/(z - z_j) = (1/side) sum_k c_k t^-(k+1)
///   local expansion   f(z) = (1/side) sum_l L_l t^l
///   velocity          u - i v = f/(2 pi i)
/// and D = (target centre - source centre)/side, a pair of integers,
///
///   M2L   L_l += (-1/D)^l sum_k binom(k+l, l) c_k D^-(k+1)
///   M2M   C_k += d^k sum_m binom(k, m) (2d)^-m c_m,          d = (child - parent)/(parent's side)
///   L2L   l_m += 1/2 (2d)^-m sum_l binom(l, m) d^l L_l
///
/// each a diagonal, Pascal's real matrix, a diagonal. No power leaves the range of doubles: |D| is
/// between 2 and 4.3, |2d| is 0.71.
///
/// Orbits: a quarter turn of D multiplies D^-(k+1) by i^-(k+1) and (-1/D)^l by i^-l. So the sources
/// at D, iD, -D and -iD, c^(0) .. c^(3), share one application of the matrix: with their butterfly
///   F_t = sum_m i^(-mt) c^(m)
/// row l of the product needs only y_r[k] = D^-(k+1) F_{(r+k+1) mod 4}[k], r = l mod 4. The 27
/// places around a child fall into ten orbits. Exact; additions in place of products.
///
/// twin    specification.hpp
/// source  Carrier, Greengard & Rokhlin 1988 for the operators

template <class Number>
struct VectorOf;
template <>
struct VectorOf<double> {
  using Type = Lanes;
  static constexpr int count = lane_count;
};
template <>
struct VectorOf<float> {
  using Type = Singles;
  static constexpr int count = single_count;
};

template <class Number>
struct ComplexLanes {
  typename VectorOf<Number>::Type re, im;
};

inline constexpr int orbit_count = 10;

/// One of each orbit: D up to quarter turns.
struct Offset {
  int x, y;
};
inline constexpr std::array<Offset, orbit_count> orbits{
    {{2, 0}, {2, 1}, {1, 2}, {2, 2}, {3, 0}, {3, 1}, {1, 3}, {3, 2}, {2, 3}, {3, 3}}};

/// Places of the four turns of an orbit around the child in a quadrant: 4 neighbor + quadrant in
/// the parent's neighbors, or -1 where the place is too near or too far to be in V.
using OrbitPlaces = std::array<std::array<std::array<int, 4>, orbit_count>, 4>;

constexpr OrbitPlaces make_orbit_places() {
  OrbitPlaces places{};
  for (int q = 0; q < 4; ++q) {
    for (int o = 0; o < orbit_count; ++o) {
      Offset d = orbits[o];
      for (int m = 0; m < 4; ++m, d = {-d.y, d.x}) {
        const int x = q % 2 - d.x + 2, y = q / 2 - d.y + 2;  // in the grid of the nine families
        const bool inside = x >= 0 && x < 6 && y >= 0 && y < 6;
        places[q][o][m] = inside ? 4 * (3 * (y / 2) + x / 2) + x % 2 + 2 * (y % 2) : -1;
      }
    }
  }
  return places;
}
inline constexpr OrbitPlaces orbit_places = make_orbit_places();

/// Powers and binomials up to an order.
template <class Number>
struct TranslationTables {
  struct Power {
    Number re, im;
  };
  struct Orbit {
    int terms;                   // of both series that this distance asks for
    std::vector<Power> in, out;  // D^-(k+1) and (-1/D)^l
  };
  struct Child {
    std::vector<Power> up, down;  // d^k and (2d)^-m
  };

  int order = 0;
  std::vector<Number> pascal;  // binom(k+l, l), order x order
  std::vector<Number> lower;   // binom(k, m) in row k, zero above the diagonal
  std::vector<Number> upper;   // binom(l, m)/2 in row m, zero below the diagonal
  std::array<Orbit, orbit_count> orbit;
  std::array<Child, 4> child;

  TranslationTables() = default;
  /// terms   of each orbit, none above order
  TranslationTables(int order, const std::array<int, orbit_count>& terms);
};

/// sums[i] = sum_{first <= k < last} rows[i][k] x[k].
template <int count, class Number>
inline void apply_rows(const Number* const (&rows)[count], const ComplexLanes<Number>* x, int first,
                       int last, ComplexLanes<Number> (&sums)[count]) {
  using Vector = typename VectorOf<Number>::Type;
  Vector re[count] = {}, im[count] = {};
  for (int k = first; k < last; ++k) {
    const Vector xr = x[k].re, xi = x[k].im;
    for (int i = 0; i < count; ++i) {
      re[i] += rows[i][k] * xr;
      im[i] += rows[i][k] * xi;
    }
  }
  for (int i = 0; i < count; ++i) sums[i] = {re[i], im[i]};
}

/// `use(row, sum)` for the rows first, first + step, ... below end of matrix x.
template <class Number, class Use>
inline void for_rows(const Number* matrix, int stride, int first, int step, int end,
                     const ComplexLanes<Number>* x, int k_first, int k_last, Use use) {
  int row = first;
  const auto block = [&]<int count>() {
    const Number* rows[count];
    ComplexLanes<Number> sums[count];
    for (int i = 0; i < count; ++i) rows[i] = matrix + (row + i * step) * stride;
    apply_rows<count, Number>(rows, x, k_first, k_last, sums);
    for (int i = 0; i < count; ++i) use(row + i * step, sums[i]);
    row += count * step;
  };
  while (row + 3 * step < end) block.template operator()<4>();
  if (row + 2 * step < end) return block.template operator()<3>();
  if (row + step < end) return block.template operator()<2>();
  if (row < end) block.template operator()<1>();
}

template <class Number, class Power>
inline ComplexLanes<Number> times(const ComplexLanes<Number>& a, const Power& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

/// y_r[k] of an orbit: y + r * stride, for r = 0 .. 3.
template <class Number>
inline void butterfly(const ComplexLanes<Number>* const (&c)[4],
                      const typename TranslationTables<Number>::Orbit& orbit,
                      ComplexLanes<Number>* y, int stride) {
  using Complexes = ComplexLanes<Number>;
  for (int k = 0; k < orbit.terms; ++k) {
    const Complexes a{c[0][k].re + c[2][k].re, c[0][k].im + c[2][k].im};
    const Complexes b{c[0][k].re - c[2][k].re, c[0][k].im - c[2][k].im};
    const Complexes e{c[1][k].re + c[3][k].re, c[1][k].im + c[3][k].im};
    const Complexes d{c[1][k].re - c[3][k].re, c[1][k].im - c[3][k].im};
    const Complexes turned[4] = {{a.re + e.re, a.im + e.im},
                                 {b.re + d.im, b.im - d.re},
                                 {a.re - e.re, a.im - e.im},
                                 {b.re - d.im, b.im + d.re}};
    const auto power = orbit.in[k];
    for (int t = 0; t < 4; ++t) y[((t - k - 1) & 3) * stride + k] = times(turned[t], power);
  }
}

/// Adds all sources of an orbit, of which there must be one, to the local expansions of a child.
/// y   room for 4 * order
template <class Number>
inline void add_orbit(const TranslationTables<Number>& tables, int o,
                      const ComplexLanes<Number>* const (&sources)[4], ComplexLanes<Number>* y,
                      ComplexLanes<Number>* local) {
  const auto& orbit = tables.orbit[o];
  const int order = tables.order;
  butterfly<Number>(sources, orbit, y, order);
  for (int r = 0; r < 4; ++r) {
    for_rows<Number>(tables.pascal.data(), order, r, 4, orbit.terms, y + r * order, 0, orbit.terms,
                     [&](int l, const ComplexLanes<Number>& sum) {
                       const auto scaled = times(sum, orbit.out[l]);
                       local[l].re += scaled.re;
                       local[l].im += scaled.im;
                     });
  }
}

/// Adds the multipoles of the children in a quadrant to their parents'. y: room for order.
template <class Number>
inline void add_child(const TranslationTables<Number>& tables, int quadrant,
                      const ComplexLanes<Number>* child, ComplexLanes<Number>* y,
                      ComplexLanes<Number>* parent) {
  const auto& at = tables.child[quadrant];
  const int order = tables.order;
  for (int m = 0; m < order; ++m) y[m] = times(child[m], at.down[m]);
  for (int first = 0; first < order; first += 4) {
    const int end = first + 4 < order ? first + 4 : order;
    for_rows<Number>(tables.lower.data(), order, first, 1, end, y, 0, end,
                     [&](int k, const ComplexLanes<Number>& sum) {
                       const auto scaled = times(sum, at.up[k]);
                       parent[k].re += scaled.re;
                       parent[k].im += scaled.im;
                     });
  }
}

/// Sets the local expansions of the children in a quadrant to their parents'. y: room for order.
template <class Number>
inline void shift_to_child(const TranslationTables<Number>& tables, int quadrant,
                           const ComplexLanes<Number>* parent, ComplexLanes<Number>* y,
                           ComplexLanes<Number>* child) {
  const auto& at = tables.child[quadrant];
  const int order = tables.order;
  for (int l = 0; l < order; ++l) y[l] = times(parent[l], at.up[l]);
  for (int first = 0; first < order; first += 4) {
    const int end = first + 4 < order ? first + 4 : order;
    for_rows<Number>(
        tables.upper.data(), order, first, 1, end, y, first, order,
        [&](int m, const ComplexLanes<Number>& sum) { child[m] = times(sum, at.down[m]); });
  }
}

/// Turns a square of numbers about its diagonal: lane j of v[i] becomes lane i of v[j].
template <class Number>
inline void transpose(typename VectorOf<Number>::Type* v) {
  using Vector = typename VectorOf<Number>::Type;
  constexpr int n = VectorOf<Number>::count;
  const auto swap_blocks = [&]<int step, int... lane>(std::integer_sequence<int, lane...>) {
    for (int i = 0; i < n; ++i) {
      if (i & step) continue;
      const Vector a = v[i], b = v[i + step];
      v[i] = __builtin_shufflevector(a, b, ((lane & step) ? n + lane - step : lane)...);
      v[i + step] = __builtin_shufflevector(a, b, ((lane & step) ? n + lane : lane + step)...);
    }
  };
  constexpr auto lanes = std::make_integer_sequence<int, n>{};
  swap_blocks.template operator()<1>(lanes);
  if constexpr (n > 2) swap_blocks.template operator()<2>(lanes);
  if constexpr (n > 4) swap_blocks.template operator()<4>(lanes);
  if constexpr (n > 8) swap_blocks.template operator()<8>(lanes);
}

/// The sum over the lanes of each of as many vectors as they have lanes.
template <class Number>
inline typename VectorOf<Number>::Type side_by_side(const typename VectorOf<Number>::Type* sums) {
  constexpr int n = VectorOf<Number>::count;
  typename VectorOf<Number>::Type part[n];
  for (int k = 0; k < n; ++k) part[k] = sums[k];
  transpose<Number>(part);
  for (int width = n / 2; width > 0; width /= 2) {
    for (int k = 0; k < width; ++k) part[k] += part[k + width];
  }
  return part[0];
}

/// Series are stored cell by cell, `padded` real parts, then as many imaginary parts; padded is a
/// multiple of the lanes. gather: from[i] is the series of lane i; scatter stores where to[i] is
/// not null.
template <class Number>
inline void gather_series(const Number* const* from, int padded, ComplexLanes<Number>* to) {
  constexpr int n = VectorOf<Number>::count;
  typename VectorOf<Number>::Type re[n], im[n];
  for (int first = 0; first < padded; first += n) {
    for (int i = 0; i < n; ++i) re[i] = load(from[i] + first);
    for (int i = 0; i < n; ++i) im[i] = load(from[i] + padded + first);
    transpose<Number>(re);
    transpose<Number>(im);
    for (int i = 0; i < n; ++i) to[first + i] = {re[i], im[i]};
  }
}

template <class Number>
inline void scatter_series(const ComplexLanes<Number>* from, int padded, Number* const* to) {
  constexpr int n = VectorOf<Number>::count;
  typename VectorOf<Number>::Type re[n], im[n];
  for (int first = 0; first < padded; first += n) {
    for (int i = 0; i < n; ++i) re[i] = from[first + i].re, im[i] = from[first + i].im;
    transpose<Number>(re);
    transpose<Number>(im);
    for (int i = 0; i < n; ++i) {
      if (to[i] == nullptr) continue;
      store(to[i] + first, re[i]);
      store(to[i] + padded + first, im[i]);
    }
  }
}

}  // namespace vortree::fmm
