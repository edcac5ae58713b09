#include "fmm/lists/interactions.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fmm/geometry/cells.hpp"
#include "point_sets.hpp"
#include "tree/build/build_reverse.hpp"
#include "tree/build/split_rule.hpp"

using namespace vortree;

namespace {

/// Points in Morton order and their tree, as a Plan holds them.
struct Side {
  tree::Quadtree tree;
  fmm::SortedPoints points;
  fmm::CellShapes shapes;

  Side(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& core,
       std::uint32_t capacity, int finest)
      : tree(tree::build_reverse(tree::morton_order({x, y}, tree::enclose({x, y}), finest),
                                 tree::crowded(capacity))) {
    for (const std::uint32_t j : tree.order()) {
      points.x.push_back(x[j]), points.y.push_back(y[j]), points.core.push_back(core[j]);
    }
    shapes = fmm::CellShapes(tree, points);
  }
};

fmm::TargetBox box(const Side& side, std::uint32_t c) {
  return {side.shapes.x[c], side.shapes.y[c], side.shapes.half_x[c], side.shapes.half_y[c],
          side.shapes.core[c]};
}

/// Of each source: how often it is met, how, and by which cell.
struct Met {
  std::vector<int> times;
  bool cores_hidden = true, converges = true;
};

void check_hidden(const Side& sources, const Side& targets, tree::Range leaf, std::uint32_t j,
                  const fmm::Acceptance& acceptance, Met& met) {
  for (std::uint32_t i = leaf.first; i < leaf.last; ++i) {
    const double dx = targets.points.x[i] - sources.points.x[j];
    const double dy = targets.points.y[i] - sources.points.y[j];
    const double reach2 = acceptance.squared_reach(sources.points.core[j], targets.points.core[i]);
    if (dx * dx + dy * dy < reach2 * (1 - 1e-12)) met.cores_hidden = false;
  }
}

/// The series of the cell converges at every target of the leaf, from the points themselves.
void check_ratio(const Side& sources, const Side& targets, tree::Range leaf, std::uint32_t cell,
                 const fmm::Acceptance& acceptance, Met& met) {
  const double x = sources.shapes.x[cell], y = sources.shapes.y[cell];
  double radius = 0.0, distance = 1e300;
  const tree::Range range = sources.tree.cells()[cell].points;
  for (std::uint32_t j = range.first; j < range.last; ++j) {
    radius = std::max(radius, std::hypot(sources.points.x[j] - x, sources.points.y[j] - y));
  }
  for (std::uint32_t i = leaf.first; i < leaf.last; ++i) {
    distance = std::min(distance, std::hypot(targets.points.x[i] - x, targets.points.y[i] - y));
  }
  const double ratio = std::sqrt(acceptance.order.squared_ratio());
  if (!(radius <= ratio * distance * (1 + 1e-12))) met.converges = false;
}

/// What `leaf` meets as a part of `block`, which holds it.
Met meet(const Side& sources, const Side& targets, std::uint32_t block, std::uint32_t leaf,
         const fmm::Acceptance& acceptance) {
  fmm::SharedInteractions shared;
  fmm::Interactions found;
  fmm::find_shared(sources.tree, sources.shapes, box(targets, block), acceptance, shared);
  fmm::find_interactions(sources.tree, sources.shapes, box(targets, leaf), acceptance,
                         shared.waiting, found);
  Met met{std::vector<int>(sources.points.size())};
  const tree::Range range = targets.tree.cells()[leaf].points;
  const auto count = [&](tree::Range run, bool hidden) {
    for (std::uint32_t j = run.first; j < run.last; ++j) {
      ++met.times[j];
      if (hidden) check_hidden(sources, targets, range, j, acceptance, met);
    }
  };
  for (const auto* series : {&shared.series, &found.series}) {
    for (const fmm::SeriesCell cell : *series) {
      count(sources.tree.cells()[cell.cell].points, true);
      check_ratio(sources, targets, range, cell.cell, acceptance, met);
    }
  }
  for (const tree::Range run : found.bare) count(run, true);
  for (const tree::Range run : found.cored) count(run, false);
  return met;
}

/// Every target of every leaf counts every source once.
void check_lists(const Side& sources, const Side& targets, const fmm::Acceptance& acceptance) {
  bool once = true, hidden = true, converges = true;
  for (const std::uint32_t leaf : targets.tree.childless()) {
    std::int32_t block = static_cast<std::int32_t>(leaf);
    for (int rise = 0; rise < 4 && block >= 0; ++rise) {
      const Met met = meet(sources, targets, static_cast<std::uint32_t>(block), leaf, acceptance);
      for (const int times : met.times) once = once && times == 1;
      hidden = hidden && met.cores_hidden;
      converges = converges && met.converges;
      block = targets.tree.cells()[static_cast<std::size_t>(block)].parent;
    }
  }
  CHECK(once);
  CHECK(hidden);
  CHECK(converges);
}

std::vector<double> cores(std::size_t n, int kind, test::Uniform& uniform) {
  std::vector<double> core(n);
  for (double& value : core) {
    const double sigma = kind == 0   ? 0.0
                         : kind == 1 ? 0.05
                         : kind == 2 ? std::pow(10.0, -6.0 * uniform())
                         : uniform() < 3.0 / static_cast<double>(n) ? 1.0
                                                                    : 1e-3;
    value = sigma * sigma;
  }
  return core;
}

}  // namespace

TEST_CASE("with a kernel of one, every target counts every source, and only where it may") {
  test::Uniform uniform(11);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const auto kind = test::every_kind[round % 3];
    const test::PointSet a = test::make_points(kind, 1 + uniform.below(900));
    const test::PointSet b = test::make_points(test::every_kind[round % 2], 1 + uniform.below(200));
    const auto capacity = static_cast<std::uint32_t>(1 + uniform.below(30));
    const int finest = round % 5 == 0 ? 4 : tree::max_level;
    const Side sources(a.x, a.y, cores(a.size(), round % 4, uniform), capacity, finest);
    const Side others(b.x, b.y, cores(b.size(), round % 3, uniform), capacity, finest);
    const double tolerance = std::pow(10.0, -2.0 - 10.0 * uniform());
    const fmm::Acceptance acceptance{
        .order = round % 2 == 0 ? fmm::SeriesOrder::for_tolerance(tolerance)
                                : fmm::SeriesOrder::fixed(7),
        .reach2 = round % 4 == 0 ? 0.0 : std::log(1.0 / tolerance),
        .cores = round % 3 == 0 ? fmm::Cores::mean : fmm::Cores::source};
    check_lists(sources, sources, acceptance);
    check_lists(sources, others, acceptance);
  }
}

TEST_CASE("terms chosen for a ratio keep the stated bound, and grow with it") {
  for (const double tolerance : {0.5, 1e-2, 1e-6, 1e-12, 1e-15}) {
    const fmm::SeriesOrder order = fmm::SeriesOrder::for_tolerance(tolerance);
    int last = 0;
    for (double ratio = 0.0; ratio < fmm::widest_ratio; ratio += 0.01) {
      const int terms = order.terms(ratio * ratio);
      CHECK(terms >= last);
      CHECK(std::pow(ratio, terms) / (1 - ratio) <= std::sqrt(terms + 1.0) * tolerance);
      last = terms;
    }
    CHECK(order.most() >= last);
    CHECK(order.most() == fmm::terms_for(tolerance, fmm::widest_ratio));
  }
}
