#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "fmm/evaluator.hpp"
#include "fmm/geometry/units.hpp"
#include "fmm/options.hpp"
#include "fmm/sources.hpp"
#include "tree/base/phase.hpp"
#include "tree/build/quadtree.hpp"

namespace vortree::fmm {

/// Velocities of many blobs at many places, their gradient and the stream function. Made once for a
/// set of blobs, asked any number of times.
///
///   u_i = sum_j gamma_j/(2 pi) (1 - exp(-r^2/S)) / r^2 (-dy, dx),  (dx, dy) = x_i - x_j
///
/// with S as Options::cores says; S = 0 is the bare vortex 1/r^2, r = 0 contributes nothing.
///
/// error    ||u - u_exact||_2 <= max(tolerance ||u_exact||_2, round_off ||sum_j |u_ij| ||_2), and
///          99 % of the targets within tolerance * sum_j |u_ij|    (tests/fmm/tolerance_sweep.cpp)
///          Where sums cancel, what is lost is no longer small beside what is left. Every sum adds
///          up what it is expected to lose (Expected); if that is more than is promised, it is
///          done again with more terms, in doubles, at the price of a new plan of the same blobs
///          (tests/fmm/losses/cancelling.cpp). round_off is what doubles cannot do better.
///          Cells meet by series only where no core shows any more: gap >= sqrt(S ln(1/tolerance)).
/// method   SumMethod::fmm in O(n). Where wide cores lie among narrow ones, so that most cells
///          would have to meet point by point, it gives way to SumMethod::boxes, which guards every
///          source by itself.
/// threads  OpenMP; results are the same bit for bit for any number of threads
/// source   Carrier, Greengard & Rokhlin, SIAM J. Sci. Stat. Comput. 9 (1988);
///          Huang, Huang, Xu & Hu, Thermal Science 16 (2012)
class Plan {
 public:
  /// phase   told "tree", "upward", and with SumMethod::fmm "far"; then "near" (fmm, direct) or
  ///         "evaluate" (boxes) as each sum begins
  /// cost    the blobs are copied
  /// throws  std::invalid_argument for blobs as check() does, and for options out of range; every
  ///         sum also for results that over- or underflow in the units of the input
  Plan(const Sources& sources, const Options& options, const tree::Phase& phase = {});

  /// At the blobs themselves.
  /// u, v    as many as blobs [m/s], in their input order; overwritten
  void velocity(std::span<double> u, std::span<double> v) const;

  /// At the blobs themselves, velocity and gradient() in one sweep.
  ///
  /// error   ||u|| as velocity(u, v); the gradient's ||.||_2 <= 10 tolerance
  ///         (tests/fmm/together.cpp)
  /// cost    of blobs with cores by SumMethod::fmm 1.6 times velocity(u, v); else as both, in turn
  void velocity_and_gradient(std::span<double> u, std::span<double> v, std::span<double> ux,
                             std::span<double> uy, std::span<double> vx) const;

  /// Elsewhere.
  void velocity(const Targets& targets, std::span<double> u, std::span<double> v) const;

  /// Elsewhere, all cores taken as nothing.
  void velocity_bare(tree::Points targets, std::span<double> u, std::span<double> v) const;

  /// How the velocity changes from place to place.
  ///
  ///   du/dx = -dv/dy = sum_j g_j b 2 dx dy / r^2          g_j = gamma_j/(2 pi),  q = r^2/S
  ///   (dv/dx + du/dy)/2 = sum_j g_j b (dy^2 - dx^2)/r^2   b = (1 - (1 + q) exp(-q))/r^2
  ///   (dv/dx - du/dy)/2 = sum_j g_j exp(-q)/S             half the vorticity
  ///
  /// throws       std::invalid_argument for cores narrower than 6e-67 extents of the blobs
  /// ux, uy, vx   du/dx, du/dy, dv/dx, as many as targets [1/s]; overwritten
  /// targets      may be the blobs; r = 0 contributes the rotation of the core, nothing if bare
  /// error        ||.||_2 of all four as for the velocity        (tests/fmm/field/derivatives.cpp)
  /// cost         O(n + m) with SumMethod::fmm, O(m log n) with SumMethod::boxes, else O(m n)
  void gradient(const Targets& targets, std::span<double> ux, std::span<double> uy,
                std::span<double> vx) const;

  /// psi with u = d psi/dy, v = -d psi/dx.
  ///
  ///   psi = -sum_j gamma_j/(2 pi) (ln r + E1(r^2/S)/2),   E1(q) = int_q^inf exp(-t)/t dt
  ///
  /// which stays finite under a core: ln r + E1(r^2/S)/2 -> (ln S - 0.5772...)/2 as r -> 0.
  ///
  /// psi       as many as targets [m^2/s]; overwritten. Lengths under the logarithm are in the unit
  ///           of the positions
  /// targets   may be the blobs; bare blobs contribute nothing at r = 0
  /// error     ||.||_2 as for the velocity                       (tests/fmm/field/derivatives.cpp)
  /// throws    std::invalid_argument for cores narrower than 6e-67 or wider than 1e60 extents
  /// cost      as gradient()
  void stream_function(const Targets& targets, std::span<double> psi) const;

  [[nodiscard]] std::size_t size() const { return size_; }
  /// What sums: Options::method, unless it gave way.
  [[nodiscard]] SumMethod method() const { return method_; }
  /// The most terms of any series.
  [[nodiscard]] int order() const { return sums_->order(); }
  /// Empty by SumMethod::direct.
  [[nodiscard]] const tree::Quadtree& tree() const { return sums_->tree(); }
  /// What velocity(u, v) computes, counted by walking again.
  [[nodiscard]] Work work() const { return sums_->work(); }
  /// Memory held.
  [[nodiscard]] std::size_t bytes() const { return sums_->bytes(); }
  /// The blobs, in their input order; cores as they are summed, to the last bits of their squares.
  [[nodiscard]] SourceColumns sources() const { return sums_->sources(); }

 private:
  template <class Sum>
  void settle(Sum sum) const;

  std::size_t size_;
  Units units_;
  std::array<std::string, 2> cores_unfit_;  // for a gradient, for a stream function
  Options options_;
  tree::Phase phase_;
  SumMethod method_;
  std::unique_ptr<const Evaluator> sums_;
};

}  // namespace vortree::fmm
