#include <algorithm>

#include "fmm/adaptive/adaptive.hpp"
#include "fmm/field/field.hpp"
#include "fmm/mutual/mutual_cores.hpp"
#include "fmm/mutual/mutual_near.hpp"
#include "tree/base/parallel.hpp"

namespace vortree::fmm {

/// What a thread needs, kept from run of leaves to run of leaves.
template <std::size_t sums>
struct Adaptive::Scratch {
  MutualNear bare;
  MutualCores<sums> cored;
  std::vector<tree::Range> runs;
  PackedSources sources;

  void take_sources(const Leaves& leaves) {
    std::size_t most = 0;
    for (const tree::Range run : runs) most += run.size();
    sources.restart(most);
    for (const tree::Range run : runs) {
      const std::size_t first = run.first;
      sources.add(&leaves.points.x[first], &leaves.points.y[first], &leaves.gamma[first],
                  run.size());
    }
    sources.close();
  }
};

/// The places of all points that the points of a childless cell meet one by one, its own among
/// them, cell by cell.
///
/// turning   points at the same place count
void Adaptive::near_cells(std::uint32_t leaf, bool turning, std::vector<tree::Range>& runs) const {
  runs.clear();
  const auto cells = tree_.cells();
  const std::uint32_t own = tree_.childless()[leaf];
  const auto add = [&](std::uint32_t c) { runs.push_back(leaves_.places(lists_.leaves(c))); };
  const bool idle = !turning && leaves_.in_one_place(leaf);
  if (lists_.neighbors(own)[InteractionLists::middle] != nobody && !idle) add(own);
  lists_.for_each_ahead(own, add);
  lists_.for_each_behind(own, add);
  for (auto c = static_cast<std::int32_t>(own); c != nobody; c = cells[c].parent) {
    for (const std::uint32_t q : lists_.refused(static_cast<std::uint32_t>(c))) add(q);
  }
}

/// The same, ascending, with what lies side by side as one.
void Adaptive::near_runs(std::uint32_t leaf, bool turning, std::vector<tree::Range>& runs) const {
  near_cells(leaf, turning, runs);
  std::ranges::sort(runs, {}, &tree::Range::first);
  std::size_t last = 0;
  for (std::size_t k = 1; k < runs.size(); ++k) {
    if (runs[k].first == runs[last].last) {
      runs[last].last = runs[k].last;
    } else {
      runs[++last] = runs[k];
    }
  }
  if (!runs.empty()) runs.resize(last + 1);
}

namespace {

/// The slopes at the points of a childless cell.
FieldTargets slopes_of(const Leaves& leaves, std::uint32_t leaf,
                       const std::array<double*, slope_sums>& to) {
  const std::uint32_t first = leaves.start[leaf];
  return {&leaves.points.x[first],
          &leaves.points.y[first],
          nullptr,
          {to[2] + first, to[3] + first, to[4] + first},
          leaves.size[leaf]};
}

}  // namespace

/// The series of a cell and of its W, where they are asked for.
template <std::size_t sums>
void Adaptive::add_far(tree::Range leaf_run, const Sums<sums>& to) const {
  std::visit(
      [&](const auto& far) {
        for (std::uint32_t leaf = leaf_run.first; leaf < leaf_run.last; ++leaf) {
          const std::uint32_t first = leaves_.start[leaf], own = tree_.childless()[leaf];
          const double *x = &leaves_.points.x[first], *y = &leaves_.points.y[first];
          const NearTargets at{x, y, nullptr, to[0] + first, to[1] + first, leaves_.size[leaf]};
          far.l2p(stage(), own, at);
          for (const std::uint32_t c : lists_.w(leaf)) far.m2p(stage(), c, at);
          if constexpr (sums == slope_sums) {
            const FieldTargets slopes = slopes_of(leaves_, leaf, to);
            FieldGradient{}.add_local(far.view_local(own), tree_.frame(own), own, slopes);
            for (const std::uint32_t c : lists_.w(leaf)) {
              FieldGradient{}.add_multipole(far.view_multipole(c), tree_.frame(c), slopes);
            }
          }
        }
      },
      far_);
}

template <std::size_t sums>
void Adaptive::add_near(tree::Range leaf_run, Scratch<sums>& scratch, const Sums<sums>& to) const {
  constexpr bool slopes = sums == slope_sums;
  if (!leaves_.cored()) scratch.bare.add(leaf_run, to[0], to[1]);
  if (!leaves_.cored() && !slopes) return;
  const tree::Range places = leaves_.places(leaf_run);
  for (std::uint32_t leaf = leaf_run.first; leaf < leaf_run.last; ++leaf) {
    near_runs(leaf, slopes && leaves_.cored(), scratch.runs);
    if (leaves_.cored()) {
      scratch.cored.add(leaf, places, scratch.runs, to);
    } else if constexpr (slopes) {
      scratch.take_sources(leaves_);
      FieldGradient{}.add_bare(scratch.sources, slopes_of(leaves_, leaf, to));
    }
  }
}

/// What the points of a cell meet one by one.
NearErrors Adaptive::near_errors(std::uint32_t cell) const {
  NearErrors near{.own = charges_[cell].squares,
                  .side2 = tree_.frame(cell).side * tree_.frame(cell).side,
                  .points = static_cast<double>(tree_.cells()[cell].points.size())};
  const bool cored = leaves_.cored();
  if (cored) near.own_core = least_core_[cell], near.least_core = Units::largest_core;
  const auto add = [&](std::uint32_t c) {
    near.squares += charges_[c].squares;
    if (!cored) return;
    near.least_core = std::min(near.least_core, least_core_[c]);
    near.widest_core = std::max(near.widest_core, core_[c]);
  };
  for (const std::int32_t c : lists_.neighbors(cell)) {
    if (c != nobody) add(static_cast<std::uint32_t>(c));
  }
  for (auto c = static_cast<std::int32_t>(cell); cored && c != nobody;
       c = tree_.cells()[c].parent) {
    for (const std::uint32_t q : lists_.refused(static_cast<std::uint32_t>(c))) add(q);
  }
  return near;
}

/// What was found in a run of leaves, and lost: of the velocity (derivative 0) or of the slopes
/// (1).
template <std::size_t sums>
Expected Adaptive::expect(tree::Range leaf_run, const Sums<sums>& all, const FarErrors& far,
                          int derivative) const {
  const bool single = coarse(options_);
  const double reach2 = core_reach2(options_.tolerance);
  const std::size_t from = derivative == 0 ? 0 : velocity_sums;
  const std::size_t to = derivative == 0 ? velocity_sums : sums;
  Expected expected;
  for (std::uint32_t leaf = leaf_run.first; leaf < leaf_run.last; ++leaf) {
    const std::uint32_t cell = tree_.childless()[leaf];
    const std::size_t first = leaves_.start[leaf], size = leaves_.size[leaf];
    for (std::size_t s = from; s < to; ++s) {
      expected.found += sum_of_squares({all[s] + first, size});
    }
    Lost lost = far.at(cell);
    for (const std::uint32_t c : lists_.w(leaf)) {
      const double side = tree_.frame(c).side;
      lost += far.of_multipole(charges_[c], side, FarErrors::side_away2 * side * side);
    }
    if (single || leaves_.cored()) {
      const NearErrors near = near_errors(cell);
      lost += near.faded(reach2, derivative);
      if (single) lost += near.rounding(derivative);
    }
    expected.lost += static_cast<double>(size) * lost;
  }
  return expected;
}

/// From the sums of a run of leaves to what was asked for.
template <std::size_t sums>
void Adaptive::hand_out(tree::Range leaf_run, const Sums<sums>& all,
                        const Sums<sums>& results) const {
  const tree::Range places = leaves_.places(leaf_run);
  const auto some = [&](std::size_t s) { return std::span(all[s] + places.first, places.size()); };
  for (std::size_t s = 0; s < velocity_sums; ++s) units_.to_velocity(some(s));
  if constexpr (sums == slope_sums) finish_gradient(units_, some(3), some(2), some(4));
  const auto cells = tree_.cells();
  const auto order = tree_.order();
  for (std::uint32_t leaf = leaf_run.first; leaf < leaf_run.last; ++leaf) {
    const tree::Range points = cells[tree_.childless()[leaf]].points;
    const std::uint32_t first = leaves_.start[leaf] - points.first;
    for (std::uint32_t j = points.first; j < points.last; ++j) {
      for (std::size_t s = 0; s < sums; ++s) results[s][order[j]] = all[s][first + j];
    }
  }
}

template <std::size_t sums>
Expected Adaptive::sweep(const Sums<sums>& results) const {
  if (phase_) phase_("near");
  const FarErrors slopes = sums == slope_sums ? far_errors(1) : FarErrors();
  std::vector<Expected> expected(leaf_runs_.size()), expected_slopes(leaf_runs_.size());
  std::array<Reals, sums> memory;
  Sums<sums> all;
  for (std::size_t s = 0; s < sums; ++s) {
    memory[s].resize(leaves_.places());
    all[s] = memory[s].data();
  }
  const auto make_scratch = [&] {
    return Scratch<sums>{
        {tree_, lists_, leaves_, coarse(options_)},
        {leaves_, options_.cores, core_reach2(options_.tolerance), coarse(options_)},
        {},
        {}};
  };
  const auto sum = [&](std::uint32_t s, Scratch<sums>& scratch) {
    const tree::Range leaf_run = leaf_runs_[s], places = leaves_.places(leaf_run);
    for (double* column : all) std::fill_n(column + places.first, places.size(), 0.0);
    add_near(leaf_run, scratch, all);
    add_far(leaf_run, all);
    expected[s] = expect(leaf_run, all, errors_, 0);
    if (sums == slope_sums) expected_slopes[s] = expect(leaf_run, all, slopes, 1);
    hand_out(leaf_run, all, results);
  };
  tree::share_in_turn(tree::all_of(leaf_runs_.size()), 1, leaf_runs_.size() > 1, make_scratch, sum);
  const Expected velocity = total(expected);
  Expected slope = total(expected_slopes);
  units_.check_range(velocity.found, size(), 0);
  units_.check_range(slope.found, size(), 1);
  slope.lost = 1 / (slope_tolerance * slope_tolerance) * slope.lost;
  return worse(velocity, slope);
}

Expected Adaptive::velocity(std::span<double> u, std::span<double> v) const {
  return sweep<velocity_sums>({u.data(), v.data()});
}

Expected Adaptive::velocity_and_gradient(std::span<double> u, std::span<double> v,
                                         std::span<double> ux, std::span<double> uy,
                                         std::span<double> vx) const {
  return sweep<slope_sums>({u.data(), v.data(), uy.data(), ux.data(), vx.data()});
}

}  // namespace vortree::fmm
