#pragma once

#include "fmm/evaluator.hpp"
#include "fmm/geometry/units.hpp"
#include "fmm/options.hpp"
#include "tree/base/phase.hpp"

namespace vortree::fmm {

/// Every pair summed, as direct.hpp does.
///
/// error  round-off
/// cost   O(n) for each target
class PairSums final : public Evaluator {
 public:
  /// phase   told "near" at each sum
  PairSums(const Sources& sources, const Options& options, const tree::Phase& phase);

  Expected velocity(std::span<double> u, std::span<double> v) const override;
  Expected velocity_and_gradient(std::span<double> u, std::span<double> v, std::span<double> ux,
                                 std::span<double> uy, std::span<double> vx) const override;
  Expected velocity(const Targets& targets, std::span<double> u,
                    std::span<double> v) const override;
  Expected velocity_bare(tree::Points targets, std::span<double> u,
                         std::span<double> v) const override;
  Expected gradient(const Targets& targets, std::span<double> ux, std::span<double> uy,
                    std::span<double> vx) const override;
  Expected stream_function(const Targets& targets, std::span<double> psi) const override;

  [[nodiscard]] int order() const override { return 0; }
  [[nodiscard]] const tree::Quadtree& tree() const override { return no_tree_; }
  [[nodiscard]] Work work() const override;
  [[nodiscard]] std::size_t bytes() const override;
  [[nodiscard]] SourceColumns sources() const override { return sources_; }

 private:
  [[nodiscard]] Targets themselves() const { return {sources_.x, sources_.y, sources_.sigma}; }
  void tell() const {
    if (phase_) phase_("near");
  }

  SourceColumns sources_;
  Cores cores_;
  tree::Phase phase_;
  tree::Quadtree no_tree_;
};

}  // namespace vortree::fmm
