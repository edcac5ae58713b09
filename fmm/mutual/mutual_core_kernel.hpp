#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include "fmm/cores/core_kernel.hpp"
#include "fmm/near/p2p_kernel.hpp"
#include "fmm/series/translation_kernel.hpp"
#include "fmm/tuning.hpp"
#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// Near sums of vortices with Gaussian cores by Newton's third law, in double or single precision:
/// the points of a cell, one after the other, and a vector of other points.
///
///   u_i -= gamma_j w_i dy, v_i += gamma_j w_i dx;   u_j += gamma_i w_j dy, v_j -= gamma_i w_j dx
///   w = core(q)/r^2, q = r^2/S, (dx, dy) = x_i - x_j
///   meet_bare         w_i = w_j = 1/r^2
///   MutualMeanCore    w_i = w_j, S = (S_i + S_j)/2: one exponential and one division serve both
///   MutualSourceCore  w_i with S = S_j, w_j with S = S_i: one division, two exponentials
///
/// and, if asked, of how they change from place to place (field.hpp), from the same exponential:
///
///   strain_i += gamma_j s_i (dy^2 - dx^2 + 2 i dx dy)   s = (w - turn)/r^2
///   rotation_i += gamma_j turn_i                        turn = exp(-q)/S, without core 0
///
/// Points at the same place do nothing to each other but turn by their cores. Lengths near one; in
/// floats no S may be less than 1e-6 of the squared extent (MutualCores sees to that).
///
/// twin    pair_weight_plain; Gradient (field.hpp)

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

/// What is summed of pairs: u, v, and where slopes are asked for the strain, real and imaginary
/// part, and the rotation.
inline constexpr std::size_t velocity_sums = 2, slope_sums = 5;

/// A weight comes in two steps: `prepare` leaves what depends on the distance, `finish` turns it
/// into w, s and turn: upon i from the first place on, upon j from `others` on. What is asked of S
/// is packed once.
inline constexpr int kept_places = 6;

/// w where 1/r^2 was, and s and turn where 1/S was; by the error of s r^2, that of the rotation, no
/// digit is lost as r vanishes.
template <class Exp, bool slopes, class Vector>
inline void weigh(Vector q, Vector inverse, Vector inverse_core, Vector* kept) {
  const Vector seen = core<Exp>(q);
  kept[0] = seen * inverse;
  if (!slopes) return;
  kept[2] = (1 - seen) * inverse_core;
  kept[1] = (kept[0] - kept[2]) * inverse;
}

template <class Exp>
struct MutualMeanCore {
  static constexpr int others = 0;

  template <class Value>
  static Value packed(Value squared_core) {
    return squared_core * half_of<Value> + tiny_of<Value>;
  }
  /// With d = 1/(r^2 S), 1/S = r^2 d and 1/r^2 = S d.
  template <bool slopes, class Vector, class Number>
  static void prepare(Vector r2, Number half_core, Vector half_cores, Vector (&kept)[kept_places]) {
    const Vector both = half_cores + half_core;
    const Vector inverse = Number{1} / (r2 * both);
    kept[0] = (r2 * inverse) * r2, kept[1] = both * inverse;
    if constexpr (slopes) {
      kept[2] = r2 * inverse;
      if constexpr (!in_floats<Number>) kept[2] = both > 4 * tiny ? kept[2] : Vector{};
    }
  }
  template <bool slopes, class Vector>
  static void finish(Vector (&kept)[kept_places]) {
    weigh<Exp, slopes>(kept[0], kept[1], slopes ? kept[2] : Vector{}, kept);
  }
};

template <class Exp>
struct MutualSourceCore {
  static constexpr int others = 3;

  template <class Value>
  static Value packed(Value squared_core) {
    return 2 * half_of<Value> / (squared_core + tiny_of<Value>);
  }
  template <bool slopes, class Vector, class Number>
  static void prepare(Vector r2, Number inverse_core, Vector inverse_cores,
                      Vector (&kept)[kept_places]) {
    kept[0] = r2 * inverse_cores, kept[1] = Number{1} / r2;
    kept[3] = r2 * inverse_core;
    if (slopes) kept[2] = of_a_core(inverse_cores), kept[5] = of_a_core(fill(inverse_core));
  }
  template <bool slopes, class Vector>
  static void finish(Vector (&kept)[kept_places]) {
    const Vector inverse = kept[1];
    weigh<Exp, slopes>(kept[0], inverse, slopes ? kept[2] : Vector{}, kept);
    weigh<Exp, slopes>(kept[3], inverse, slopes ? kept[5] : Vector{}, kept + 3);
  }

 private:
  /// 1/S, nothing where S is.
  template <class Vector>
  static Vector of_a_core(Vector inverse_core) {
    if constexpr (in_floats<Vector>)
      return inverse_core;
    else
      return inverse_core < 1 / (4 * tiny) ? inverse_core : Vector{};
  }
};

/// The points of a cell with their packed S, and room for a vector a point and sum.
template <class Number, std::size_t sums>
struct CellPoints {
  const Number *x, *y, *gamma, *core;
  std::array<typename VectorOf<Number>::Type*, sums> sum;
  std::size_t size;
};

/// Other points side by side, S packed, and their sums.
template <class Vector, std::size_t sums>
struct OtherPoints {
  Vector x, y, gamma, core, sum[sums];
};

/// Without cores. both: the others gain, too.
template <bool both, class Number, std::size_t sums>
inline void meet_bare(const CellPoints<Number, sums>& cell,
                      OtherPoints<typename VectorOf<Number>::Type, sums>& others) {
  using Vector = typename VectorOf<Number>::Type;
  constexpr bool slopes = sums == slope_sums;
  const Vector x = others.x, y = others.y, gamma = others.gamma;
  Vector u{}, v{}, re{}, im{};
  for (std::size_t i = 0; i < cell.size; ++i) {
    const Vector dx = cell.x[i] - x, dy = cell.y[i] - y;
    const Vector w = Number{1} / (dx * dx + (dy * dy + tiny_of<Number>));
    const Vector along = w * dx, across = w * dy;
    cell.sum[0][i] -= gamma * across;
    cell.sum[1][i] += gamma * along;
    if (both) u += cell.gamma[i] * across, v -= cell.gamma[i] * along;
    if constexpr (slopes) {
      const Vector strain_re = (across - along) * (across + along);
      const Vector strain_im = (along + along) * across;
      cell.sum[2][i] += gamma * strain_re;
      cell.sum[3][i] += gamma * strain_im;
      if (both) re += cell.gamma[i] * strain_re, im += cell.gamma[i] * strain_im;
    }
  }
  if (!both) return;
  others.sum[0] = u, others.sum[1] = v;
  if constexpr (slopes) others.sum[2] = re, others.sum[3] = im, others.sum[4] = Vector{};
}

/// With cores. Each step is done for some points of the cell before the next one: a pair's weight
/// is a long chain of operations that wait for each other, and short loops keep more of them going
/// at once.
template <class Weight, bool both, class Number, std::size_t sums>
inline void meet_cored(const CellPoints<Number, sums>& cell,
                       OtherPoints<typename VectorOf<Number>::Type, sums>& others) {
  using Vector = typename VectorOf<Number>::Type;
  constexpr bool slopes = sums == slope_sums;
  constexpr std::size_t some = points_a_step;
  const Vector x = others.x, y = others.y, gamma = others.gamma, cores = others.core;
  Vector u{}, v{}, re{}, im{}, rotation{};
  Vector kept[some][kept_places];
  for (std::size_t first = 0; first < cell.size; first += some) {
    const std::size_t last = std::min(first + some, cell.size);
    for (std::size_t i = first; i < last; ++i) {
      const Vector dx = cell.x[i] - x, dy = cell.y[i] - y;
      const Vector r2 = dx * dx + (dy * dy + tiny_of<Number>);
      Weight::template prepare<slopes>(r2, cell.core[i], cores, kept[i - first]);
    }
    for (std::size_t k = 0; k < last - first; ++k) Weight::template finish<slopes>(kept[k]);
    for (std::size_t i = first; i < last; ++i) {
      const Vector dx = cell.x[i] - x, dy = cell.y[i] - y;
      const Vector* upon = kept[i - first];
      const Vector* back = upon + Weight::others;
      const Vector upon_cell = upon[0] * gamma;
      cell.sum[0][i] -= upon_cell * dy;
      cell.sum[1][i] += upon_cell * dx;
      if (both) {
        const Vector upon_others = back[0] * cell.gamma[i];
        u += upon_others * dy;
        v -= upon_others * dx;
      }
      if constexpr (slopes) {
        const Vector across = (dy - dx) * (dy + dx), mixed = (dx + dx) * dy;
        const Vector strain = upon[1] * gamma;
        cell.sum[2][i] += strain * across;
        cell.sum[3][i] += strain * mixed;
        cell.sum[4][i] += upon[2] * gamma;
        if (both) {
          const Vector strain_back = back[1] * cell.gamma[i];
          re += strain_back * across;
          im += strain_back * mixed;
          rotation += back[2] * cell.gamma[i];
        }
      }
    }
  }
  if (!both) return;
  others.sum[0] = u, others.sum[1] = v;
  if constexpr (slopes) others.sum[2] = re, others.sum[3] = im, others.sum[4] = rotation;
}

}  // namespace vortree::fmm
