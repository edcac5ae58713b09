#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fmm/losses/expected.hpp"
#include "fmm/sources.hpp"
#include "tree/build/quadtree.hpp"

namespace vortree::fmm {

/// How much the sums of all blobs upon all blobs compute.
///
/// series   cells met by their series, once for each target leaf, block of leaves or cell
/// terms    terms of them, once for each target (box-to-point)
/// bare     pairs of target and source summed without core
/// cored    pairs summed with core
/// ... in_floats   such pairs are summed in single precision wherever it is exact enough
struct Work {
  std::uint64_t series = 0, terms = 0, bare = 0, cored = 0;
  bool bare_in_floats = false, cored_in_floats = false;
};

/// Sources that own their values.
struct SourceColumns {
  std::vector<double> x, y, gamma, sigma;  // sigma is empty if all are bare
  [[nodiscard]] Sources view() const { return {x, y, gamma, sigma}; }
};

/// The gradient may be wrong by so many tolerances where it comes with the velocity.
inline constexpr double slope_tolerance = 10.0;

/// A way to sum, made for a set of blobs; what Plan hides. Results are in the user's units; every
/// sum says how far off it is expected to be, and throws what Units::check_range does.
class Evaluator {
 public:
  virtual ~Evaluator() = default;
  virtual Expected velocity(std::span<double> u, std::span<double> v) const = 0;
  virtual Expected velocity_and_gradient(std::span<double> u, std::span<double> v,
                                         std::span<double> ux, std::span<double> uy,
                                         std::span<double> vx) const = 0;
  virtual Expected velocity(const Targets& targets, std::span<double> u,
                            std::span<double> v) const = 0;
  virtual Expected velocity_bare(tree::Points targets, std::span<double> u,
                                 std::span<double> v) const = 0;
  virtual Expected gradient(const Targets& targets, std::span<double> ux, std::span<double> uy,
                            std::span<double> vx) const = 0;
  virtual Expected stream_function(const Targets& targets, std::span<double> psi) const = 0;
  [[nodiscard]] virtual int order() const = 0;
  [[nodiscard]] virtual const tree::Quadtree& tree() const = 0;
  [[nodiscard]] virtual Work work() const = 0;
  [[nodiscard]] virtual std::size_t bytes() const = 0;
  /// What it was made for, in input order; cores as they are summed.
  [[nodiscard]] virtual SourceColumns sources() const = 0;
};

}  // namespace vortree::fmm
