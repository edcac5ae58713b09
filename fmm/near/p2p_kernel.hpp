#pragma once

#include <cmath>
#include <cstddef>

#include "fmm/cores/core_kernel.hpp"
#include "fmm/near/packed.hpp"
#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// Near sums: every target counts every source.
///
///   u_i = sum_j gamma_j w(r^2) (-dy),  v_i = sum_j gamma_j w(r^2) dx,   (dx, dy) = x_i - x_j
///   BarePair         w = 1/r^2
///   SourceCorePair   w = core(r^2/S)/r^2,  S = S_j
///   MeanCorePair     the same,             S = (S_i + S_j)/2
///
/// No factor 1/(2 pi). Lengths and circulations come in Units, near one. Sources at a target's own
/// place contribute nothing. Lanes are sources, four targets stay in registers.
/// cost    one division a pair and, with a core, one exponential
/// twin    pair_weight_plain

/// Added to r^2 and S: nothing divides by zero, and a pair at r = 0 ends as finite times zero.
inline constexpr double tiny = 1e-150;

/// A pair's weight w. What the kernels ask of a source's S is packed once by packed_core; of the
/// target's S they ask half.

struct BarePair {
  static double packed_core(double) { return 0.0; }
  static float packed_core_single(double) { return 0.0f; }

  template <class Vector, class Number, int rows>
  static void weigh(const Vector (&r2)[rows], Vector, const Number*, Vector gamma,
                    Vector (&w)[rows]) {
    for (int i = 0; i < rows; ++i) w[i] = gamma / r2[i];
  }
};

template <class Exp>
struct SourceCorePair {
  static double packed_core(double squared_core) { return 1.0 / (squared_core + tiny); }
  static float packed_core_single(double squared_core) {
    return static_cast<float>(1.0 / squared_core);
  }

  template <class Vector, class Number, int rows>
  static void weigh(const Vector (&r2)[rows], Vector inverse_core, const Number*, Vector gamma,
                    Vector (&w)[rows]) {
    Vector q[rows], bare[rows];
    for (int i = 0; i < rows; ++i) bare[i] = gamma / r2[i];
    for (int i = 0; i < rows; ++i) q[i] = r2[i] * inverse_core;
    core<Exp>(q, w);
    for (int i = 0; i < rows; ++i) w[i] *= bare[i];
  }
};

template <class Exp>
struct MeanCorePair {
  static double packed_core(double squared_core) { return 0.5 * squared_core + tiny; }
  static float packed_core_single(double squared_core) {
    return static_cast<float>(0.5 * squared_core);
  }

  /// One division serves both: with d = 1/(r^2 S), 1/S = r^2 d and 1/r^2 = S d.
  template <int rows>
  static void weigh(const Lanes (&r2)[rows], Lanes half_core, const double* half_target_core,
                    Lanes gamma, Lanes (&w)[rows]) {
    Lanes q[rows], bare[rows];
    for (int i = 0; i < rows; ++i) {
      const Lanes both = half_core + half_target_core[i];
      const Lanes inverse = 1.0 / (r2[i] * both);
      q[i] = (r2[i] * inverse) * r2[i];
      bare[i] = (both * inverse) * gamma;
    }
    core<Exp>(q, w);
    for (int i = 0; i < rows; ++i) w[i] *= bare[i];
  }

  /// In floats two divisions are the faster way.
  template <int rows>
  static void weigh(const Singles (&r2)[rows], Singles half_core, const float* half_target_core,
                    Singles gamma, Singles (&w)[rows]) {
    Singles q[rows];
    for (int i = 0; i < rows; ++i) q[i] = r2[i] / (half_core + half_target_core[i]);
    core<Exp>(q, w);
    for (int i = 0; i < rows; ++i) w[i] *= gamma / r2[i];
  }
};

/// Targets of a near sum; the sums are added to u and v. core is read by MeanCorePair only.
struct NearTargets {
  const double *x, *y, *core;
  double *u, *v;
  std::size_t size;
};

template <class Pair, int rows>
inline void p2p_rows(const PackedSources& sources, const NearTargets& targets, std::size_t first) {
  Lanes u[rows] = {}, v[rows] = {};
  double half_core[rows];
  for (int i = 0; i < rows; ++i) half_core[i] = 0.5 * targets.core[first + i];
  for (std::size_t j = 0; j < sources.size(); j += lane_count) {
    const Lanes x = load(sources.x() + j), y = load(sources.y() + j);
    Lanes dx[rows], dy[rows], r2[rows], w[rows];
    for (int i = 0; i < rows; ++i) {
      dx[i] = targets.x[first + i] - x;
      dy[i] = targets.y[first + i] - y;
      r2[i] = dx[i] * dx[i] + (dy[i] * dy[i] + tiny);
    }
    Pair::weigh(r2, load(sources.core() + j), half_core, load(sources.gamma() + j), w);
    for (int i = 0; i < rows; ++i) {
      u[i] -= w[i] * dy[i];
      v[i] += w[i] * dx[i];
    }
  }
  for (int i = 0; i < rows; ++i) {
    targets.u[first + i] += sum(u[i]);
    targets.v[first + i] += sum(v[i]);
  }
}

/// sources must be closed.
template <class Pair>
void p2p(const PackedSources& sources, const NearTargets& targets) {
  if (sources.size() == 0) return;
  std::size_t i = 0;
  for (; i + 4 <= targets.size; i += 4) p2p_rows<Pair, 4>(sources, targets, i);
  switch (targets.size - i) {
    case 3:
      return p2p_rows<Pair, 3>(sources, targets, i);
    case 2:
      return p2p_rows<Pair, 2>(sources, targets, i);
    case 1:
      return p2p_rows<Pair, 1>(sources, targets, i);
    default:
      return;
  }
}

/// One pair, said plainly: the weight gamma_j w(r^2), 0 where they coincide; S = 0 is bare.
template <class Real>
Real pair_weight_plain(Real r2, Real gamma, Real squared_core) {
  if (r2 == 0) return 0;
  const Real bare = gamma / r2;
  return squared_core == 0 ? bare : bare * core_plain(static_cast<double>(r2 / squared_core));
}

}  // namespace vortree::fmm
