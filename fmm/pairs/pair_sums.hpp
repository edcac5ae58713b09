#pragma once

#include "fmm/evaluator.hpp"
#include "fmm/geometry/units.hpp"
#include "fmm/options.hpp"

namespace vortree::fmm {

/// Every pair summed, as direct.hpp does.
///
/// error  round-off
/// cost   O(n) for each target
class PairSums final : public Evaluator {
 public:
  /// phase   told "near" at each sum
  PairSums(const Blobs& blobs, const Options& options, const Phase& phase);

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
  [[nodiscard]] BlobColumns blobs() const override { return blobs_; }

 private:
  [[nodiscard]] Targets themselves() const { return {blobs_.x, blobs_.y, blobs_.sigma}; }
  void tell() const {
    if (phase_) phase_("near");
  }

  BlobColumns blobs_;
  Cores cores_;
  Phase phase_;
  tree::Quadtree no_tree_;
};

}  // namespace vortree::fmm
