#include "fmm/adaptive/at_targets.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fmm/tuning.hpp"
#include "tree/base/parallel.hpp"
#include "tree/order/sort.hpp"

namespace vortree::fmm {
namespace {}  // namespace

TargetBox around(const NearTargets& targets) {
  double left = targets.x[0], right = left, bottom = targets.y[0], top = bottom, widest = 0.0;
  for (std::size_t i = 0; i < targets.size; ++i) {
    left = std::min(left, targets.x[i]), right = std::max(right, targets.x[i]);
    bottom = std::min(bottom, targets.y[i]), top = std::max(top, targets.y[i]);
    if (targets.core != nullptr) widest = std::max(widest, targets.core[i]);
  }
  const double x = 0.5 * left + 0.5 * right, y = 0.5 * bottom + 0.5 * top;
  return {x, y, std::max(right - x, x - left), std::max(top - y, y - bottom), widest};
}

/// The smallest cell that holds a place (in Units).
std::uint32_t Adaptive::holder(double x, double y) const {
  if (tree_.cells().empty()) return outside;
  const auto holds = [&](std::uint32_t c) {
    const CellFrame& at = tree_.frame(c);
    return std::abs((x - at.x) - at.x_rest) <= at.side / 2 &&
           std::abs((y - at.y) - at.y_rest) <= at.side / 2;
  };
  if (!holds(0)) return outside;
  std::uint32_t c = 0;
  while (true) {
    const CellFrame& at = tree_.frame(c);
    const int right = (x - at.x) - at.x_rest >= 0.0, upper = (y - at.y) - at.y_rest >= 0.0;
    const std::int32_t child = lists_.children(c)[right + 2 * upper];
    if (child == nobody) return c;
    c = static_cast<std::uint32_t>(child);
  }
}

/// All sources that the local expansion of the cell leaves out, or all there are: from the cells
/// that hold them downward, by series where they serve the whole box, else point by point.
void Adaptive::find_sources(std::uint32_t cell, const TargetBox& box, const Acceptance& accepted,
                            Elsewhere& found) const {
  found.restart();
  if (tree_.cells().empty()) return;
  const auto start = [&](std::uint32_t c) {
    if (std::ranges::find(found.open, c) == found.open.end()) found.open.push_back(c);
  };
  if (cell == outside) {
    start(0);
  } else {
    for (const std::int32_t near : lists_.neighbors(cell)) {
      if (near != nobody) start(static_cast<std::uint32_t>(near));
    }
    if (tree_.cells()[cell].childless()) lists_.for_each_ahead(cell, start);
    for (auto c = static_cast<std::int32_t>(cell); c != nobody; c = tree_.cells()[c].parent) {
      // Finer ones lie inside the neighbors of a childless cell.
      for (const std::uint32_t q : lists_.refused(static_cast<std::uint32_t>(c))) {
        if (tree_.cells()[q].level <= tree_.cells()[c].level) start(q);
      }
    }
  }
  while (!found.open.empty()) {
    const std::uint32_t c = found.open.back();
    found.open.pop_back();
    const CellFrame& at = tree_.frame(c);
    const double half = at.side / 2;
    const double gap_x = std::max(0.0, std::abs(at.x - box.x) - box.half_x - half);
    const double gap_y = std::max(0.0, std::abs(at.y - box.y) - box.half_y - half);
    const double core = core_.empty() ? 0.0 : core_[c];
    const bool hidden = gap_x * gap_x + gap_y * gap_y >= accepted.squared_reach(core, box.core);
    const bool apart = std::max(gap_x, gap_y) >= at.side;
    const DeepCell& here = tree_.cells()[c];
    if (apart && hidden && here.points.size() > few_points) {
      found.series.push_back(c);
    } else if (here.childless()) {
      (hidden ? found.near.bare : found.near.cored).push_back(leaves_.places(lists_.leaves(c)));
    } else {
      for (std::uint32_t k = here.children.first; k < here.children.last; ++k) {
        found.open.push_back(k);
      }
    }
  }
}

namespace {

/// Where batches begin among targets in the order of their cells, and the end.
std::vector<std::size_t> find_batches(const std::vector<Held>& held) {
  std::vector<std::size_t> first;
  for (std::size_t k = 0; k < held.size(); ++k) {
    if (k == 0 || held[k].cell != held[k - 1].cell || k - first.back() == targets_a_batch) {
      first.push_back(k);
    }
  }
  first.push_back(held.size());
  return first;
}

}  // namespace

void take(const Targets& targets, const Units& units, std::span<const Held> held, Batch& batch) {
  const std::size_t whole = padded(held.size(), single_count);
  for (auto* values : {&batch.x, &batch.y, &batch.core}) values->resize(whole);
  for (auto* values : {&batch.u, &batch.v}) values->assign(whole, 0.0);
  for (std::size_t i = 0; i < whole; ++i) {
    const std::uint32_t from = held[std::min(i, held.size() - 1)].index;
    batch.x[i] = units.position(targets.x[from]);
    batch.y[i] = units.position(targets.y[from]);
    batch.core[i] = targets.sigma.empty() ? 0.0 : units.squared_core(targets.sigma[from]);
  }
  batch.size = held.size();
}

/// What series are expected to lose at a target of a box.
template <class Number>
Lost Adaptive::lost_far(const FarErrors& errors, const FarField<Number>& far, std::uint32_t cell,
                        const TargetBox& box, const Elsewhere& found) const {
  Lost lost;
  if (cell != outside) lost = errors.at(cell);
  for (const std::uint32_t c : found.series) {
    const CellFrame& at = tree_.frame(c);
    const double dx = std::max(0.0, std::abs(at.x - box.x) - box.half_x);
    const double dy = std::max(0.0, std::abs(at.y - box.y) - box.half_y);
    lost += errors.of_multipole(far.charges()[c], at.side, dx * dx + dy * dy);
  }
  return lost;
}

template Lost Adaptive::lost_far(const FarErrors&, const FarField<double>&, std::uint32_t,
                                 const TargetBox&, const Elsewhere&) const;
template Lost Adaptive::lost_far(const FarErrors&, const FarField<float>&, std::uint32_t,
                                 const TargetBox&, const Elsewhere&) const;

/// What it is expected to lose at a target.
Lost Adaptive::sum_batch(std::uint32_t cell, bool cored, Elsewhere& found) const {
  Batch& batch = found.batch;
  const NearTargets at{batch.x.data(), batch.y.data(), batch.core.data(),
                       batch.u.data(), batch.v.data(), batch.size};
  const Acceptance accepted = acceptance(cored);
  const TargetBox box = around(at);
  find_sources(cell, box, accepted, found);
  Lost lost = std::visit(
      [&](const auto& far) {
        if (cell != outside) far.l2p(stage(), cell, at);
        for (const std::uint32_t c : found.series) far.m2p(stage(), c, at);
        return lost_far(errors_, far, cell, box, found);
      },
      far_);
  found.sources.pack(leaves_.points, leaves_.gamma, box, accepted, found.near);
  if (!cored) {
    found.sources.sum<BarePair>(box, at, false);
    return lost;
  }
  const bool coarse = std::holds_alternative<FarField<float>>(far_);
  with_pair(options_.cores, coarse,
            [&]<class Pair>() { found.sources.sum<Pair>(box, at, coarse); });
  lost += found.sources.lost(accepted.reach2, 0, coarse);
  return lost;
}

/// Targets in Morton order, then by the cell that holds them.
Adaptive::Groups Adaptive::group(const Targets& targets, bool cored) const {
  const tree::Points places{targets.x, targets.y};
  const tree::MortonOrder sorted = tree::morton_order(places, tree::enclose(places));
  // Where cores are averaged, a target's own core may show where the cells' cores do not.
  const bool wide = cored && options_.cores == Cores::mean && !targets.sigma.empty();
  Groups groups;
  groups.held.resize(targets.size());
  const auto hold = [&](std::uint32_t k) {
    const std::uint32_t i = sorted.index[k];
    const double x = units_.position(targets.x[i]), y = units_.position(targets.y[i]);
    groups.held[k] = {wide ? outside : holder(x, y), i};
  };
  tree::share_evenly(tree::all_of(targets.size()), targets.size() > tree::records_worth_sharing,
                     hold);
  std::ranges::stable_sort(groups.held, {}, &Held::cell);
  groups.first = find_batches(groups.held);
  return groups;
}

Expected Adaptive::evaluate_elsewhere(const Targets& targets, bool cored, std::span<double> u,
                                      std::span<double> v) const {
  if (targets.size() == 0) return {};
  const Groups groups = group(targets, cored);
  std::vector<Expected> expected(groups.size());
  const auto sum = [&](std::uint32_t b, Elsewhere& found) {
    const std::span<const Held> some = groups[b];
    take(targets, units_, some, found.batch);
    const Lost lost = sum_batch(some[0].cell, cored, found);
    const auto square = [&](const std::vector<double>& sums) {
      return sum_of_squares(std::span(sums).first(some.size()));
    };
    expected[b] = {square(found.batch.u) + square(found.batch.v),
                   static_cast<double>(some.size()) * lost};
    for (std::size_t i = 0; i < some.size(); ++i) {
      u[some[i].index] = found.batch.u[i];
      v[some[i].index] = found.batch.v[i];
    }
  };
  tree::share_in_turn(
      tree::all_of(groups.size()), 4, groups.size() > 4, [] { return Elsewhere(); }, sum);
  const Expected all = total(expected);
  units_.check_range(all.found, targets.size(), 0);
  units_.to_velocity(u);
  units_.to_velocity(v);
  units_.finish_far(std::accumulate(leaves_.gamma.begin(), leaves_.gamma.end(), 0.0), targets.x,
                    targets.y, u, v);
  return all;
}

bool Adaptive::cored(const Targets& targets) const {
  return leaves_.cored() ||
         (options_.cores == Cores::mean &&
          std::ranges::any_of(targets.sigma, [](double sigma) { return sigma > 0.0; }));
}

Expected Adaptive::velocity(const Targets& targets, std::span<double> u,
                            std::span<double> v) const {
  return evaluate_elsewhere(targets, cored(targets), u, v);
}

Expected Adaptive::velocity_bare(tree::Points targets, std::span<double> u,
                                 std::span<double> v) const {
  return evaluate_elsewhere({targets.x, targets.y, {}}, false, u, v);
}

}  // namespace vortree::fmm
