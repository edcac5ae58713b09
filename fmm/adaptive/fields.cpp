#include <algorithm>
#include <numeric>

#include "fmm/adaptive/at_targets.hpp"
#include "fmm/adaptive/stream_constants.hpp"
#include "fmm/field/field.hpp"
#include "tree/base/parallel.hpp"

namespace vortree::fmm {

/// The cell itself or an ancestor so wide that no core reaches across it: all that its local
/// expansion stands for is a cell away.
std::uint32_t Adaptive::wide_cell(std::uint32_t cell, double reach2) const {
  const double widest = core_.empty() ? 0.0 : core_[0];
  while (cell != outside) {
    const double side = tree_.frame(cell).side;
    const std::int32_t parent = tree_.cells()[cell].parent;
    if (side * side >= reach2 * widest || parent == nobody) break;
    cell = static_cast<std::uint32_t>(parent);
  }
  return cell;
}

/// The local expansion of a cell that holds a group, series of cells near it, and sources one by
/// one: as velocities elsewhere (full_elsewhere.cpp), but in doubles throughout.
template <class Field, class Number>
Expected Adaptive::evaluate_field(const Field& field, const FarField<Number>& far,
                                  const FarErrors& errors, const Targets& targets,
                                  std::array<double*, 3> results) const {
  for (std::size_t s = 0; s < Field::count; ++s) std::fill_n(results[s], targets.size(), 0.0);
  if (targets.size() == 0 || tree_.cells().empty()) return {};
  const bool with_cores = cored(targets);
  Acceptance accepted = acceptance(with_cores);
  if (with_cores) accepted.reach2 = Field::reach2(options_.tolerance);
  const Groups groups = group(targets, with_cores);
  std::vector<Expected> expected(groups.size());
  struct Room {
    Elsewhere found;
    std::array<std::vector<double>, Field::count> sums;
  };
  const auto sum = [&](std::uint32_t b, Room& room) {
    auto& [found, sums] = room;
    const std::span<const Held> some = groups[b];
    const std::uint32_t own = some[0].cell;
    const std::uint32_t cell = Field::farther ? wide_cell(own, accepted.reach2) : own;
    Batch& batch = found.batch;
    take(targets, units_, some, batch);
    FieldTargets at{batch.x.data(), batch.y.data(), batch.core.data(), {}, batch.size};
    for (std::size_t s = 0; s < Field::count; ++s) {
      sums[s].assign(batch.x.size(), 0.0);
      at.sums[s] = sums[s].data();
    }
    const TargetBox box = around({at.x, at.y, at.core, batch.u.data(), batch.v.data(), batch.size});
    find_sources(cell, box, accepted, found);
    if (cell != outside) field.add_local(far.view_local(cell), tree_.frame(cell), cell, at);
    for (const std::uint32_t c : found.series) {
      field.add_multipole(far.view_multipole(c), tree_.frame(c), at);
    }
    found.sources.pack(leaves_.points, leaves_.gamma, box, accepted, found.near);
    found.sources.sum(field, CoreShares(options_.cores), at);
    for (std::size_t s = 0; s < Field::count; ++s) {
      for (std::size_t i = 0; i < some.size(); ++i) results[s][some[i].index] = sums[s][i];
      expected[b].found += sum_of_squares(std::span(sums[s]).first(some.size()));
    }
    Lost lost = lost_far(errors, far, cell, box, found);
    if (with_cores) lost += found.sources.lost(accepted.reach2, Field::derivative, false);
    expected[b].lost = static_cast<double>(some.size()) * lost;
  };
  tree::share_in_turn(
      tree::all_of(groups.size()), 4, groups.size() > 4, [] { return Room(); }, sum);
  return total(expected);
}

/// The derivative of a series of p terms lacks (p + 1)/(1 - ratio) times as much, so it has series
/// of its own, with a few more terms.
Expected Adaptive::gradient(const Targets& targets, std::span<double> ux, std::span<double> uy,
                            std::span<double> vx) const {
  const LatticeOrder order =
      options_.order > 0 ? order_
                         : LatticeOrder::for_tolerance(options_.tolerance / (2 * order_.most));
  if (phase_) phase_("far");
  FarField<double> far(stage(), TranslationTables<double>(order.most, order.terms));
  far.descend(stage());
  if (phase_) phase_("near");
  const FarErrors errors(stage(), far, order, 1);
  const Expected expected =
      evaluate_field(FieldGradient{}, far, errors, targets, {uy.data(), ux.data(), vx.data()});
  units_.check_range(expected.found, ux.size(), 1);
  finish_gradient(units_, ux, uy, vx);
  return expected;
}

Expected Adaptive::stream_function(const Targets& targets, std::span<double> psi) const {
  if (phase_) phase_("near");
  Expected expected = std::visit(
      [&](const auto& far) {
        const std::vector<double> centres = stream_constants(stage(), far);
        return evaluate_field(StreamFunction{log_unit(units_), centres}, far, far_errors(-1),
                              targets, {psi.data()});
      },
      far_);
  const double all = std::accumulate(leaves_.gamma.begin(), leaves_.gamma.end(), 0.0);
  expected.found = finish_stream_function(units_, all, targets, psi);
  units_.check_range(expected.found, psi.size(), -1);
  return expected;
}

}  // namespace vortree::fmm
