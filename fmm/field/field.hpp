#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "fmm/cores/core_log_kernel.hpp"
#include "fmm/geometry/deep_tree.hpp"
#include "fmm/geometry/units.hpp"
#include "fmm/near/packed.hpp"
#include "fmm/series/power_series.hpp"
#include "fmm/sources.hpp"

namespace vortree::fmm {

/// Targets of some sums, and the sums, which are added to. All are there up to whole vectors.
struct FieldTargets {
  const double *x, *y, *core;
  std::array<double*, 3> sums;
  std::size_t size;
};

/// The squared core of a pair: of_source S_j + of_target S_i.
struct CoreShares {
  double of_source, of_target;

  explicit CoreShares(Cores cores)
      : of_source(cores == Cores::source ? 1.0 : 0.5),
        of_target(cores == Cores::source ? 0.0 : 0.5) {}
};

/// What Plan::gradient sums, in Units. With f = sum_j gamma_j/(z - z_j) for bare blobs,
///
///   sums[0], [1]   strain     Re, Im of f' = -sum_j gamma_j / (z - z_j)^2,
///                             each pair times 1 - (1 + q) exp(-q),  q = r^2/S
///   sums[2]        rotation   sum_j gamma_j exp(-q)/S
///   2 pi (du/dx, du/dy, dv/dx) = (Im f', Re f' - rotation, Re f' + rotation)
///
/// error   near sums: round-off, against the sum of |gamma_j| times the larger of 1/S and 1/r^2
///         that shows; no digit is lost as r vanishes. Pairs of bare blobs at r = 0 contribute
///         nothing
/// twin    tests/fmm/field/derivatives.cpp, in long double
struct FieldGradient {
  static constexpr std::size_t count = 3;
  static constexpr int derivative = 1;  // of f

  /// r^2/S from which on a core counts as nothing: where what it takes from the strain, (1 + q)
  /// exp(-q) of it, is what exp(-q) is for the velocity; farther than the lists of cells go by.
  static constexpr bool farther = true;
  static double reach2(double tolerance);

  template <class Number>
  void add_multipole(const SeriesView<Number>& multipole, const CellFrame& at,
                     const FieldTargets& targets) const;
  template <class Number>
  void add_local(const SeriesView<Number>& local, const CellFrame& at, std::uint32_t cell,
                 const FieldTargets& targets) const;
  void add_bare(const PackedSources& sources, const FieldTargets& targets) const;
  void add_cored(const PackedSources& sources, CoreShares shares,
                 const FieldTargets& targets) const;
};

/// What Plan::stream_function sums, in Units:
///
///   sums[0]   2 Re Phi = sum_j gamma_j (ln r^2 + E1(r^2/S)),   Phi = sum_j gamma_j log(z - z_j)
///
/// error   near sums: round-off, against the sum of |contributions|
/// twin    tests/fmm/field/derivatives.cpp, in long double
struct StreamFunction {
  static constexpr std::size_t count = 1;
  static constexpr int derivative = -1;
  /// That of the velocity (core_reach2).
  static constexpr bool farther = false;
  static double reach2(double tolerance);

  /// unit      ln r^2 of what pairs of bare blobs at r = 0 get in its place: the user's unit
  ///           length, so that they contribute nothing there
  /// centres   the sum over what the local expansion of a cell stands for, at the cell's centre
  double unit;
  std::span<const double> centres;

  template <class Number>
  void add_multipole(const SeriesView<Number>& multipole, const CellFrame& at,
                     const FieldTargets& targets) const;
  template <class Number>
  void add_local(const SeriesView<Number>& local, const CellFrame& at, std::uint32_t cell,
                 const FieldTargets& targets) const;
  void add_bare(const PackedSources& sources, const FieldTargets& targets) const;
  void add_cored(const PackedSources& sources, CoreShares shares,
                 const FieldTargets& targets) const;
};

/// ln r^2 of the user's unit length, in Units.
[[nodiscard]] double log_unit(const Units& units);

/// The sums in the user's units, in place: from strain and rotation to du/dx, du/dy, dv/dx, and
/// from logarithms to psi.
///
/// all       the sum of all circulations, in Units
/// returns   the sum of squares of what stands for psi in the unit of the sums
void finish_gradient(const Units& units, std::span<double> ux, std::span<double> uy,
                     std::span<double> vx);
double finish_stream_function(const Units& units, double all, const Targets& targets,
                              std::span<double> psi);

}  // namespace vortree::fmm
