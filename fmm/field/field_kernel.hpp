#pragma once

#include "fmm/cores/core_kernel.hpp"
#include "fmm/cores/core_log_kernel.hpp"
#include "fmm/field/field.hpp"
#include "fmm/near/p2p_kernel.hpp"

namespace vortree::fmm {

/// Pairs and series of Gradient and StreamFunction (field.hpp), some vectors of sources or places
/// at once.
/// twin    tests/fmm/field/derivatives.cpp

/// 2 Re int f of a local expansion from the centre on, at places t.
template <int rows>
inline void log_of_local(const PowerSeries& integral, const Complexes (&t)[rows],
                         Lanes (&result)[rows]) {
  Complexes sum[rows];
  sum_powers<rows>(integral, t, sum);
  for (int i = 0; i < rows; ++i) result[i] = 2.0 * (t[i] * sum[i]).re;
}

/// 2 Re int f of a multipole of circulation c_0 = gamma, at places t; ln side^2 beside.
template <int rows>
inline void log_of_multipole(double gamma, double log_side2, const PowerSeries& integral,
                             const Complexes (&t)[rows], Lanes (&result)[rows]) {
  Complexes w[rows], sum[rows];
  for (int i = 0; i < rows; ++i) w[i] = reciprocal(t[i]);
  sum_powers<rows>(integral, w, sum);
  for (int i = 0; i < rows; ++i) {
    const Lanes log_t2 = logarithm(t[i].re * t[i].re + t[i].im * t[i].im);
    result[i] = gamma * (log_t2 + log_side2) + 2.0 * (w[i] * sum[i]).re;
  }
}

/// Vectors of pairs, one of each row: distances, and the sources' circulations.
template <int rows>
struct Pairs {
  Lanes dx[rows], dy[rows], r2[rows];
  Lanes gamma;

  Pairs(const PackedSources& sources, std::size_t j, const FieldTargets& targets, std::size_t first)
      : gamma(load(sources.gamma() + j)) {
    const Lanes x = load(sources.x() + j), y = load(sources.y() + j);
    for (int i = 0; i < rows; ++i) {
      dx[i] = targets.x[first + i] - x;
      dy[i] = targets.y[first + i] - y;
      r2[i] = dx[i] * dx[i] + (dy[i] * dy[i] + tiny);
    }
  }
};

/// Squared cores and logarithms of what is below this are of pairs that coincide, or of no core.
inline constexpr double next_to_nothing = 4 * tiny;

/// Strain of pairs: weight (dy^2 - dx^2, 2 dx dy)/r^2.
template <int rows>
struct Strain {
  Lanes re[rows] = {}, im[rows] = {};

  void add(const Pairs<rows>& pairs, int i, Lanes weight, Lanes inverse) {
    const Lanes ex = pairs.dx[i] * inverse, ey = pairs.dy[i] * inverse;
    re[i] += weight * (ey * pairs.dy[i] - ex * pairs.dx[i]);
    im[i] += weight * (2.0 * ex * pairs.dy[i]);
  }
  void store(const FieldTargets& targets, std::size_t first) const {
    for (int i = 0; i < rows; ++i) {
      targets.sums[0][first + i] += sum(re[i]);
      targets.sums[1][first + i] += sum(im[i]);
    }
  }
};

template <int rows>
inline void gradient_bare(const PackedSources& sources, const FieldTargets& targets,
                          std::size_t first) {
  Strain<rows> strain;
  for (std::size_t j = 0; j < sources.size(); j += lane_count) {
    const Pairs<rows> pairs(sources, j, targets, first);
    for (int i = 0; i < rows; ++i) {
      const Lanes inverse = 1.0 / pairs.r2[i];
      strain.add(pairs, i, pairs.gamma * inverse, inverse);
    }
  }
  strain.store(targets, first);
}

/// With d = 1/(r^2 S), 1/S = r^2 d and 1/r^2 = S d. Where q is small, 1 - (1 + q) exp(-q) is the
/// small difference of core(q) and q exp(-q), wrong by the last bit of q: by that of the rotation.
template <int rows>
inline void gradient_cored(const PackedSources& sources, CoreShares shares,
                           const FieldTargets& targets, std::size_t first) {
  Strain<rows> strain;
  Lanes rotation[rows] = {};
  for (std::size_t j = 0; j < sources.size(); j += lane_count) {
    const Pairs<rows> pairs(sources, j, targets, first);
    const Lanes of_source = load(sources.core() + j) * shares.of_source + tiny;
    for (int i = 0; i < rows; ++i) {
      const Lanes core2 = of_source + shares.of_target * targets.core[first + i];
      const Lanes both = 1.0 / (pairs.r2[i] * core2);
      const Lanes inverse_core = pairs.r2[i] * both, inverse = core2 * both;
      const Lanes q = pairs.r2[i] * inverse_core, seen = core<FineExp>(q);
      const Lanes left = core2 > next_to_nothing ? 1.0 - seen : Lanes{};  // exp(-q)
      rotation[i] += pairs.gamma * (left * inverse_core);
      strain.add(pairs, i, pairs.gamma * (inverse * (seen - q * left)), inverse);
    }
  }
  strain.store(targets, first);
  for (int i = 0; i < rows; ++i) targets.sums[2][first + i] += sum(rotation[i]);
}

template <int rows>
inline void stream_bare(const PackedSources& sources, double unit, const FieldTargets& targets,
                        std::size_t first) {
  Lanes total[rows] = {};
  for (std::size_t j = 0; j < sources.size(); j += lane_count) {
    const Pairs<rows> pairs(sources, j, targets, first);
    for (int i = 0; i < rows; ++i) {
      const Lanes log_r2 = logarithm(pairs.r2[i]);
      total[i] += pairs.gamma * (pairs.r2[i] > next_to_nothing ? log_r2 : fill(unit));
    }
  }
  for (int i = 0; i < rows; ++i) targets.sums[0][first + i] += sum(total[i]);
}

/// ln r^2 + E1(q) as ln S + core_log(q) where the core shows.
template <int rows>
inline void stream_cored(const PackedSources& sources, CoreShares shares, double unit,
                         const FieldTargets& targets, std::size_t first) {
  const CoreLog& core_log = CoreLog::table();
  Lanes total[rows] = {};
  for (std::size_t j = 0; j < sources.size(); j += lane_count) {
    const Pairs<rows> pairs(sources, j, targets, first);
    const Lanes of_source = load(sources.core() + j) * shares.of_source + tiny;
    for (int i = 0; i < rows; ++i) {
      const Lanes core2 = of_source + shares.of_target * targets.core[first + i];
      const Lanes q = pairs.r2[i] / core2;
      const Bits shows = q < bare_log;
      const Lanes base = shows ? core2 : pairs.r2[i];
      const Lanes log_r2 = logarithm(base) + (shows ? core_log(q) : Lanes{});
      total[i] += pairs.gamma * (base > next_to_nothing ? log_r2 : fill(unit));
    }
  }
  for (int i = 0; i < rows; ++i) targets.sums[0][first + i] += sum(total[i]);
}

}  // namespace vortree::fmm
