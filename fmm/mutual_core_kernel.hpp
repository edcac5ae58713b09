#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "fmm/core_kernel.hpp"
#include "fmm/p2p_kernel.hpp"
#include "fmm/translation_kernel.hpp"
#include "tree/lanes.hpp"

namespace vortree::fmm {

/// Near sums of vortices with Gaussian cores by Newton's third law, in double or single precision:
/// the points of a cell, one after the other, and a vector of other points.
///
///   u_i -= gamma_j w_i dy, v_i += gamma_j w_i dx;   u_j += gamma_i w_j dy, v_j -= gamma_i w_j dx
///   w = core(r^2/S)/r^2, (dx, dy) = x_i - x_j
///   MutualBare        w_i = w_j = 1/r^2
///   MutualMeanCore    w_i = w_j, S = (S_i + S_j)/2: one exponential and one division serve both
///   MutualSourceCore  w_i with S = S_j, w_j with S = S_i: one division, two exponentials
///
/// Points at the same place do nothing to each other. Lengths near one; in floats no S may be less
/// than 1e-6 of the squared extent (MutualCores sees to that).
///
/// twin    pair_weight_plain

/// The number of a value or of a vector's lanes.
template <class Value>
inline constexpr bool in_floats = std::is_same_v<Value, float> || std::is_same_v<Value, Singles>;
template <class Value>
inline constexpr auto tiny_of = [] {
  if constexpr (in_floats<Value>)
    return 1e-30f;
  else
    return tiny;
}();
template <class Value>
inline constexpr auto half_of = [] {
  if constexpr (in_floats<Value>)
    return 0.5f;
  else
    return 0.5;
}();

/// A weight comes in two steps: `prepare` leaves what depends on the distance, `finish` turns it
/// into w_i, first, and w_j, at `others`. What is asked of S is packed once.

struct MutualBare {
  template <class Value>
  static Value packed(Value) {
    return Value{};
  }
  template <class Vector, class Number>
  static void prepare(Vector r2, Number, Vector, Vector (&kept)[3]) {
    kept[0] = Number{1} / r2;
  }
  static constexpr int others = 0;
  template <class Vector>
  static void finish(Vector (&)[3]) {}
};

template <class Exp>
struct MutualMeanCore {
  template <class Value>
  static Value packed(Value squared_core) {
    return squared_core * half_of<Value> + tiny_of<Value>;
  }
  /// With d = 1/(r^2 S), 1/S = r^2 d and 1/r^2 = S d.
  template <class Vector, class Number>
  static void prepare(Vector r2, Number half_core, Vector half_cores, Vector (&kept)[3]) {
    const Vector both = half_cores + half_core;
    const Vector inverse = Number{1} / (r2 * both);
    kept[0] = (r2 * inverse) * r2, kept[1] = both * inverse;
  }
  static constexpr int others = 0;
  template <class Vector>
  static void finish(Vector (&kept)[3]) {
    kept[0] = core<Exp>(kept[0]) * kept[1];
  }
};

template <class Exp>
struct MutualSourceCore {
  template <class Value>
  static Value packed(Value squared_core) {
    return 2 * half_of<Value> / (squared_core + tiny_of<Value>);
  }
  template <class Vector, class Number>
  static void prepare(Vector r2, Number inverse_core, Vector inverse_cores, Vector (&kept)[3]) {
    kept[0] = r2 * inverse_cores, kept[1] = r2 * inverse_core, kept[2] = Number{1} / r2;
  }
  static constexpr int others = 1;
  template <class Vector>
  static void finish(Vector (&kept)[3]) {
    kept[0] = core<Exp>(kept[0]) * kept[2], kept[1] = core<Exp>(kept[1]) * kept[2];
  }
};

/// The points of a cell with their packed S, and room for a vector a point in each direction.
template <class Number>
struct CellPoints {
  const Number *x, *y, *gamma, *core;
  typename VectorOf<Number>::Type *u, *v;
  std::size_t size;
};

/// Other points side by side, S packed, and their sums.
template <class Vector>
struct OtherPoints {
  Vector x, y, gamma, core, u, v;
};

/// both: the others gain, too.
///
/// Each step is done for some points of the cell before the next one: a pair's weight is a long
/// chain of operations that wait for each other, and short loops keep more of them going at once.
template <class Weight, bool both, class Number>
inline void meet_others(const CellPoints<Number>& cell,
                        OtherPoints<typename VectorOf<Number>::Type>& others) {
  using Vector = typename VectorOf<Number>::Type;
  constexpr std::size_t some = 8;
  const Vector x = others.x, y = others.y, gamma = others.gamma, cores = others.core;
  Vector u{}, v{};
  Vector kept[some][3];
  for (std::size_t first = 0; first < cell.size; first += some) {
    const std::size_t last = std::min(first + some, cell.size);
    for (std::size_t i = first; i < last; ++i) {
      const Vector dx = cell.x[i] - x, dy = cell.y[i] - y;
      const Vector r2 = dx * dx + (dy * dy + tiny_of<Number>);
      Weight::prepare(r2, cell.core[i], cores, kept[i - first]);
    }
    for (std::size_t k = 0; k < last - first; ++k) Weight::finish(kept[k]);
    for (std::size_t i = first; i < last; ++i) {
      const Vector dx = cell.x[i] - x, dy = cell.y[i] - y;
      Vector upon_cell = kept[i - first][0], upon_others = kept[i - first][Weight::others];
      upon_cell *= gamma;
      cell.u[i] -= upon_cell * dy;
      cell.v[i] += upon_cell * dx;
      if (both) {
        upon_others *= cell.gamma[i];
        u += upon_others * dy;
        v -= upon_others * dx;
      }
    }
  }
  if (both) others.u = u, others.v = v;
}

}  // namespace vortree::fmm
