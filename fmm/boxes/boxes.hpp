#pragma once

#include <array>

#include "fmm/boxes/evaluate.hpp"
#include "fmm/evaluator.hpp"
#include "fmm/geometry/arrangement.hpp"
#include "fmm/geometry/units.hpp"
#include "fmm/options.hpp"
#include "tree/base/memory.hpp"
#include "tree/base/phase.hpp"

namespace vortree::fmm {

/// Laurent series of far cells straight to the targets, near blobs one by one. Cells are shrunk to
/// the points they hold, every pair of cells takes the terms that its ratio needs.
///
/// cost     O(n log n) time and 16 order bytes a cell
/// source   Huang, Huang, Xu & Hu, Thermal Science 16 (2012), box-to-point
class Boxes final : public Evaluator {
 public:
  /// phase   told "tree", "upward", and "evaluate" at each sum
  Boxes(const Sources& sources, const Units& units, const Options& options,
        const tree::Phase& phase);

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

  [[nodiscard]] int order() const override { return order_.most(); }
  [[nodiscard]] const tree::Quadtree& tree() const override { return sources_.tree; }
  [[nodiscard]] Work work() const override;
  [[nodiscard]] std::size_t bytes() const override;
  [[nodiscard]] SourceColumns sources() const override;

 private:
  [[nodiscard]] TreeOptions growth() const;
  [[nodiscard]] bool cored(const Arrangement& targets) const;
  [[nodiscard]] Acceptance acceptance(bool cored) const;
  template <class Field>
  Expected evaluate_field(const Field& field, const SeriesOrder& order, const Arrangement& at,
                          std::array<double*, 3> results) const;
  Expected gradient_at(const Arrangement& targets, std::span<double> ux, std::span<double> uy,
                       std::span<double> vx) const;
  Expected evaluate_at(const Arrangement& targets, bool cored, std::span<double> u,
                       std::span<double> v) const;

  Options options_;
  tree::Phase phase_;
  Units units_;
  SeriesOrder order_;
  Arrangement sources_;
  Reals gamma_;
  Multipoles multipoles_;
};

}  // namespace vortree::fmm
