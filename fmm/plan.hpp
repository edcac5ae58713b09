#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "fmm/arrangement.hpp"
#include "fmm/blobs.hpp"
#include "fmm/evaluate.hpp"
#include "fmm/reals.hpp"
#include "fmm/units.hpp"
#include "tree/quadtree.hpp"

namespace vortree::fmm {

/// tolerance      what the user is promised (Plan), in (0, 1)
/// order          terms of a multipole, 1 .. 200; 0: chosen by tolerance for every pair of cells.
///                A fixed order keeps no promise; cells then meet one cell apart, as in the paper
/// capacity       points of a childless cell at most; 0: chosen
/// finest_level   no cell lies below; 0 .. 31
struct Options {
  double tolerance = 1e-6;
  int order = 0;
  std::uint32_t capacity = 0;
  int finest_level = tree::max_level;
  Builder builder = Builder::reverse;
  Cores cores = Cores::source;
};

/// Velocities of many blobs at many places, in O(n log n): Laurent series of far cells straight to
/// the targets, near blobs one by one. Made once for a set of blobs, asked any number of times.
///
///   u_i = sum_j gamma_j/(2 pi) (1 - exp(-r^2/S)) / r^2 (-dy, dx),  (dx, dy) = x_i - x_j
///
/// with S as Options::cores says; S = 0 is the bare vortex 1/r^2, r = 0 contributes nothing.
///
/// error    ||u - u_exact||_2 <= tolerance ||u_exact||_2, and 99 % of the targets within
///          tolerance * sum_j |contribution of j|                  (tests/fmm/tolerance_sweep.cpp)
///          Cells meet by series only where no core shows any more: gap >= sqrt(S ln(1/tolerance)).
/// threads  OpenMP; results are the same bit for bit for any number of threads
/// source   Huang, Huang, Xu & Hu, Thermal Science 16 (2012), box-to-point
class Plan {
 public:
  /// Told the name of a part of the work as it begins, for whoever keeps the time.
  using Phase = std::function<void(std::string_view)>;

  /// phase   told "upward" when the tree stands and the multipoles begin
  /// cost    O(n order) time and 16 order bytes a cell; the blobs are copied
  /// throws  std::invalid_argument for blobs as check() does, and for options out of range
  Plan(const Blobs& blobs, const Options& options, const Phase& phase = {});

  /// At the blobs themselves.
  /// u, v    as many as blobs [m/s], in their input order; overwritten
  void velocity(std::span<double> u, std::span<double> v) const;

  /// Elsewhere.
  void velocity(const Targets& targets, std::span<double> u, std::span<double> v) const;

  /// Elsewhere, all cores taken as nothing.
  void velocity_bare(tree::Points targets, std::span<double> u, std::span<double> v) const;

  [[nodiscard]] std::size_t size() const { return gamma_.size(); }
  /// The most terms any multipole is evaluated with.
  [[nodiscard]] int order() const { return order_.most(); }
  [[nodiscard]] std::uint32_t capacity() const { return options_.capacity; }
  [[nodiscard]] const tree::Quadtree& tree() const { return blobs_.tree; }
  /// What velocity(u, v) computes, counted by walking again.
  [[nodiscard]] Work work() const;
  /// Memory held.
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] Acceptance acceptance(bool cored) const;
  void evaluate_at(const Arrangement& targets, bool cored, std::span<double> u,
                   std::span<double> v) const;

  Options options_;
  Units units_;
  Order order_;
  Arrangement blobs_;
  Reals gamma_;
  Multipoles multipoles_;
};

}  // namespace vortree::fmm
