#pragma once

#include <array>
#include <variant>
#include <vector>

#include "fmm/adaptive/far_field.hpp"
#include "fmm/evaluator.hpp"
#include "fmm/geometry/bounds.hpp"
#include "fmm/geometry/deep_tree.hpp"
#include "fmm/geometry/leaves.hpp"
#include "fmm/geometry/units.hpp"
#include "fmm/lists/leaf_runs.hpp"
#include "fmm/lists/lists.hpp"
#include "fmm/losses/far_errors.hpp"
#include "fmm/losses/near_errors.hpp"
#include "fmm/near/near.hpp"
#include "fmm/options.hpp"
#include "fmm/series/lattice_order.hpp"
#include "tree/base/phase.hpp"

namespace vortree::fmm {

/// The bounding box of some targets, at least one, and their widest core.
[[nodiscard]] TargetBox around(const NearTargets& targets);

/// The adaptive fast multipole method on the quadtree: multipoles upward, V and X into local
/// expansions downward, W and near sums at the points.
///
/// cost     O(n) time
/// source   Carrier, Greengard & Rokhlin, SIAM J. Sci. Stat. Comput. 9 (1988)
class Adaptive final : public Evaluator {
 public:
  /// phase   told "tree", "upward", "far", and "near" at each sum
  Adaptive(const Sources& sources, const SourceBounds& bounds, const Options& options,
           const tree::Phase& phase);

  /// False if so many cells refuse to meet by series, because of cores, that their points had
  /// better be guarded one by one. Then there are no sums.
  [[nodiscard]] bool serves() const { return serves_; }

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

  [[nodiscard]] int order() const override { return order_.most; }
  [[nodiscard]] const tree::Quadtree& tree() const override { return base_; }
  [[nodiscard]] Work work() const override;
  [[nodiscard]] std::size_t bytes() const override;
  [[nodiscard]] SourceColumns sources() const override;

 private:
  template <std::size_t sums>
  struct Scratch;
  /// Columns that are summed (mutual_core_kernel.hpp).
  template <std::size_t sums>
  using Sums = std::array<double*, sums>;
  struct Elsewhere;
  struct Groups;
  using Far = std::variant<FarField<double>, FarField<float>>;

  void grow(const Sources& sources, const SourceBounds& bounds);
  void list();
  [[nodiscard]] std::size_t size() const { return tree_.order().size(); }
  [[nodiscard]] double near_pairs() const;
  [[nodiscard]] Stage stage() const { return {tree_, lists_, leaves_}; }
  [[nodiscard]] Acceptance acceptance(bool cored) const;
  void near_cells(std::uint32_t leaf, bool turning, std::vector<tree::Range>& runs) const;
  void near_runs(std::uint32_t leaf, bool turning, std::vector<tree::Range>& runs) const;
  template <std::size_t sums>
  Expected sweep(const Sums<sums>& results) const;
  [[nodiscard]] FarErrors far_errors(int derivative) const;
  [[nodiscard]] NearErrors near_errors(std::uint32_t cell) const;
  template <std::size_t sums>
  [[nodiscard]] Expected expect(tree::Range leaf_run, const Sums<sums>& all, const FarErrors& far,
                                int derivative) const;
  template <std::size_t sums>
  void add_near(tree::Range leaf_run, Scratch<sums>& scratch, const Sums<sums>& to) const;
  template <std::size_t sums>
  void add_far(tree::Range leaf_run, const Sums<sums>& to) const;
  template <std::size_t sums>
  void hand_out(tree::Range leaf_run, const Sums<sums>& all, const Sums<sums>& results) const;
  [[nodiscard]] bool cored(const Targets& targets) const;
  [[nodiscard]] Groups group(const Targets& targets, bool cored) const;
  Expected evaluate_elsewhere(const Targets& targets, bool cored, std::span<double> u,
                              std::span<double> v) const;
  [[nodiscard]] Lost sum_batch(std::uint32_t cell, bool cored, Elsewhere& found) const;
  template <class Number>
  [[nodiscard]] Lost lost_far(const FarErrors& errors, const FarField<Number>& far,
                              std::uint32_t cell, const TargetBox& box,
                              const Elsewhere& found) const;
  template <class Field, class Number>
  Expected evaluate_field(const Field& field, const FarField<Number>& far, const FarErrors& errors,
                          const Targets& targets, std::array<double*, 3> results) const;
  [[nodiscard]] std::uint32_t wide_cell(std::uint32_t cell, double reach2) const;
  [[nodiscard]] std::uint32_t holder(double x, double y) const;
  void find_sources(std::uint32_t cell, const TargetBox& box, const Acceptance& accepted,
                    Elsewhere& found) const;

  Options options_;
  tree::Phase phase_;
  Units units_;
  LatticeOrder order_;
  tree::Quadtree base_;
  DeepTree tree_;
  Leaves leaves_;
  Reals core_;        // of each cell, the largest squared core inside; empty if bare
  Reals least_core_;  // and the least
  InteractionLists lists_;
  LeafRuns leaf_runs_;
  Far far_;
  std::span<const Charge> charges_;  // of far_
  FarErrors errors_;
  bool serves_ = true;
};

}  // namespace vortree::fmm
