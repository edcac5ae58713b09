#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "fmm/blobs.hpp"
#include "fmm/evaluator.hpp"
#include "fmm/options.hpp"
#include "tree/quadtree.hpp"

namespace vortree::fmm {

/// Velocities of many blobs at many places. Made once for a set of blobs, asked any number of
/// times.
///
///   u_i = sum_j gamma_j/(2 pi) (1 - exp(-r^2/S)) / r^2 (-dy, dx),  (dx, dy) = x_i - x_j
///
/// with S as Options::cores says; S = 0 is the bare vortex 1/r^2, r = 0 contributes nothing.
///
/// error    ||u - u_exact||_2 <= tolerance ||u_exact||_2, and 99 % of the targets within
///          tolerance * sum_j |contribution of j|                  (tests/fmm/tolerance_sweep.cpp)
///          Cells meet by series only where no core shows any more: gap >= sqrt(S ln(1/(4
///          tolerance))).
/// method   Method::fmm in O(n). Where wide cores lie among narrow ones, so that most cells would
///          have to meet point by point, it gives way to Method::boxes, which guards every source
///          by itself.
/// threads  OpenMP; results are the same bit for bit for any number of threads
/// source   Carrier, Greengard & Rokhlin, SIAM J. Sci. Stat. Comput. 9 (1988);
///          Huang, Huang, Xu & Hu, Thermal Science 16 (2012)
class Plan {
 public:
  /// phase   told "tree", "upward", and with Method::fmm "far"; then "near" (fmm) or "evaluate"
  ///         (boxes) as each sum begins
  /// cost    the blobs are copied
  /// throws  std::invalid_argument for blobs as check() does, and for options out of range
  Plan(const Blobs& blobs, const Options& options, const Phase& phase = {});

  /// At the blobs themselves.
  /// u, v    as many as blobs [m/s], in their input order; overwritten
  void velocity(std::span<double> u, std::span<double> v) const;

  /// Elsewhere.
  void velocity(const Targets& targets, std::span<double> u, std::span<double> v) const;

  /// Elsewhere, all cores taken as nothing.
  void velocity_bare(tree::Points targets, std::span<double> u, std::span<double> v) const;

  [[nodiscard]] std::size_t size() const { return size_; }
  /// What sums: Options::method, unless it gave way.
  [[nodiscard]] Method method() const { return method_; }
  /// The most terms of any series.
  [[nodiscard]] int order() const { return sums_->order(); }
  [[nodiscard]] const tree::Quadtree& tree() const { return sums_->tree(); }
  /// What velocity(u, v) computes, counted by walking again.
  [[nodiscard]] Work work() const { return sums_->work(); }
  /// Memory held.
  [[nodiscard]] std::size_t bytes() const { return sums_->bytes(); }

 private:
  std::size_t size_;
  Method method_;
  std::unique_ptr<const Evaluator> sums_;
};

}  // namespace vortree::fmm
