#include "fmm/adaptive/adaptive.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "fmm/geometry/vortices.hpp"
#include "fmm/tuning.hpp"
#include "tree/base/parallel.hpp"
#include "tree/build/split_rule.hpp"

namespace vortree::fmm {
namespace {

double leaf_size(const Options& options) {
  return options.tolerance < fine_tolerance ? even_leaf_fine : even_leaf;
}

Options resolve(Options options, const Sources& sources) {
  if (options.capacity == 0) {
    options.capacity =
        sources.sigma.empty() ? static_cast<std::uint32_t>(2 * leaf_size(options)) : cored_capacity;
  }
  options.tolerance = std::max(options.tolerance, least_tolerance);
  return options;
}

LatticeOrder choose_order(const Options& options) {
  return options.order > 0 ? LatticeOrder::fixed(options.order)
                           : LatticeOrder::for_tolerance(options.tolerance);
}

/// The factor in [1, 2) that makes the cells of some level as wide as `wished`.
double stretch(double side, double wished) {
  const double ratio = side / wished;
  if (!(ratio > 1.0) || !std::isfinite(ratio)) return 1.0;
  return std::exp2(std::ceil(std::log2(ratio))) / ratio;
}

void tell(const tree::Phase& phase, const char* name) {
  if (phase) phase(name);
}

}  // namespace

Adaptive::Adaptive(const Sources& sources, const SourceBounds& bounds, const Options& options,
                   const tree::Phase& phase)
    : options_(resolve(options, sources)),
      phase_(phase),
      units_(Units::of(bounds)),
      order_(choose_order(options_)) {
  tell(phase_, "tree");
  grow(sources, bounds);
  leaf_runs_ = LeafRuns(leaves_);
  list();
  if (!serves_) return;
  tell(phase_, "upward");
  const auto make = [&]<class Number>(Number) {
    FarField<Number> far(stage(), TranslationTables<Number>(order_.most, order_.terms));
    tell(phase_, "far");
    far.descend(stage());
    errors_ = FarErrors(stage(), far, order_, 0);
    charges_ = std::get<FarField<Number>>(far_ = std::move(far)).charges();
  };
  coarse(options_) ? make(float{}) : make(double{});
}

/// The domain is stretched so that evenly spread points fill childless cells to the optimum, or, if
/// cores reach farther than such a cell, so that cells of a level just hold that reach.
void Adaptive::grow(const Sources& sources, const SourceBounds& bounds) {
  tree::Domain domain;
  if (sources.size() > 0) {
    domain = tree::enclose({bounds.x.low, bounds.x.high}, {bounds.y.low, bounds.y.high});
  }
  const double widest = bounds.sigma.largest_magnitude();
  const double reach = widest * std::sqrt(core_reach2(options_.tolerance)) * (1 + 1e-9);
  const double leaf = widest > 0.0 ? even_cored_leaf : leaf_size(options_);
  const double even = domain.side * std::sqrt(leaf / std::max<double>(1.0, sources.size()));
  domain = tree::enlarge(domain, stretch(domain.side, std::max(even, reach)));
  tree::MortonOrder order =
      tree::morton_order({sources.x, sources.y}, domain, options_.finest_level);
  base_ = build(std::move(order), tree::crowded(options_.capacity), options_.builder);
  const Unwritten<Vortex> vortices = side_by_side(sources, units_);
  tree_ = DeepTree(base_, vortices, units_, options_.capacity,
                   options_.finest_level == tree::max_level);
  leaves_ = Leaves(tree_, vortices, widest > 0.0, coarse(options_) ? single_count : lane_count);
}

void Adaptive::list() {
  const auto cells = tree_.cells();
  if (!leaves_.cored()) {
    lists_ = InteractionLists(tree_, few_points, {});
    return;
  }
  core_.resize(cells.size(), 0.0);
  least_core_.resize(cells.size(), Units::largest_core);
  const auto childless = tree_.childless();
  tree::share_evenly(tree::all_of(childless.size()), childless.size() > tree::cells_worth_sharing,
                     [&](std::uint32_t leaf) {
                       const auto first = leaves_.points.core.begin() + leaves_.start[leaf];
                       const auto [least, most] =
                           std::minmax_element(first, first + leaves_.size[leaf]);
                       core_[childless[leaf]] = *most, least_core_[childless[leaf]] = *least;
                     });
  for (std::size_t c = cells.size(); c-- > 1;) {
    double &most = core_[cells[c].parent], &least = least_core_[cells[c].parent];
    most = std::max(most, core_[c]), least = std::min(least, least_core_[c]);
  }
  const double reach2 = core_reach2(options_.tolerance);
  lists_ = InteractionLists(tree_, few_points, [&](std::uint32_t a, std::uint32_t b, double gap) {
    return reach2 * std::max(core_[a], core_[b]) <= gap * gap;
  });
  serves_ = near_pairs() <= most_near_sources * static_cast<double>(leaves_.places());
}

double Adaptive::near_pairs() const {
  std::vector<double> pairs(leaf_runs_.size(), 0.0);
  const auto count = [&](std::uint32_t s, std::vector<tree::Range>& runs) {
    for (std::uint32_t leaf = leaf_runs_[s].first; leaf < leaf_runs_[s].last; ++leaf) {
      near_cells(leaf, false, runs);
      for (const tree::Range run : runs)
        pairs[s] += static_cast<double>(run.size()) * leaves_.size[leaf];
    }
  };
  tree::share_in_turn(
      tree::all_of(pairs.size()), 1, pairs.size() > 1, [] { return std::vector<tree::Range>(); },
      count);
  return std::accumulate(pairs.begin(), pairs.end(), 0.0);
}

Acceptance Adaptive::acceptance(bool cored) const {
  return {.order = SeriesOrder::fixed(order_.most),
          .reach2 = cored ? core_reach2(options_.tolerance) : 0.0,
          .cores = options_.cores};
}

FarErrors Adaptive::far_errors(int derivative) const {
  return std::visit([&](const auto& far) { return FarErrors(stage(), far, order_, derivative); },
                    far_);
}

SourceColumns Adaptive::sources() const {
  const auto order = tree_.order();
  SourceColumns all;
  for (auto* column : {&all.x, &all.y, &all.gamma}) column->resize(order.size());
  if (leaves_.cored()) all.sigma.resize(order.size());
  std::size_t j = 0;
  for (std::size_t leaf = 0; leaf < leaves_.count(); ++leaf) {
    for (std::uint32_t k = 0; k < leaves_.size[leaf]; ++k, ++j) {
      const std::uint32_t from = leaves_.start[leaf] + k, to = order[j];
      all.x[to] = leaves_.points.x[from] / units_.per_length;
      all.y[to] = leaves_.points.y[from] / units_.per_length;
      all.gamma[to] = leaves_.gamma[from] / units_.per_gamma;
      if (leaves_.cored()) {
        all.sigma[to] = std::sqrt(leaves_.points.core[from]) / units_.per_length;
      }
    }
  }
  return all;
}

Work Adaptive::work() const {
  Work work{.bare_in_floats = coarse(options_), .cored_in_floats = coarse(options_)};
  std::vector<tree::Range> runs;
  for (std::uint32_t leaf = 0; leaf < leaves_.count(); ++leaf) {
    near_runs(leaf, false, runs);
    std::uint64_t near = 0;
    for (const tree::Range run : runs) {
      // pads do not count
      const auto first = std::ranges::lower_bound(leaves_.start, run.first);
      for (auto k = first - leaves_.start.begin(); leaves_.start[k] < run.last; ++k) {
        near += leaves_.size[k];
      }
    }
    (leaves_.cored() ? work.cored : work.bare) += near * leaves_.size[leaf];
    work.series += lists_.w(leaf).size();
  }
  return work;
}

std::size_t Adaptive::bytes() const {
  const std::size_t per_point = sizeof(tree::MortonKey) + sizeof(std::uint32_t);
  return per_point * base_.order().size() + base_.cells().size_bytes() + tree_.bytes() +
         leaves_.bytes() + lists_.bytes() +
         std::visit([](const auto& far) { return far.bytes(); }, far_);
}

}  // namespace vortree::fmm
