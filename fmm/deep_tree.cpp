#include "fmm/deep_tree.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tree/split_rule.hpp"

namespace vortree::fmm {
namespace {

constexpr std::uint32_t alone = 2048;  // cells of a level that one thread had better do alone

/// a + b = sum + rest, exactly (Knuth).
void two_sum(double a, double b, double& sum, double& rest) {
  sum = a + b;
  const double second = sum - a;
  rest = (a - (sum - second)) + (b - second);
}

/// (x, rest) + step to twice the digits.
void move(double x, double rest, double step, double& moved, double& moved_rest) {
  double sum, lost;
  two_sum(x, step, sum, lost);
  two_sum(sum, lost + rest, moved, moved_rest);
}

Frame child_frame(const Frame& parent, int quadrant) {
  const double step = parent.side / 4;
  Frame child;
  move(parent.x, parent.x_rest, quadrant % 2 == 0 ? -step : step, child.x, child.x_rest);
  move(parent.y, parent.y_rest, quadrant / 2 == 0 ? -step : step, child.y, child.y_rest);
  child.side = 2 * step;
  return child;
}

}  // namespace

/// A tree over the points of one cell.
struct DeepTree::Graft {
  std::uint32_t cell;
  tree::Quadtree tree;
};

DeepTree::DeepTree(const tree::Quadtree& base, tree::Points points, const Units& units,
                   std::uint32_t capacity, Builder builder, bool deepen)
    : order_(base.order().begin(), base.order().end()) {
  take(base);
  if (cells_.empty()) return;
  set_frames(base.domain(), units);
  std::vector<Graft> grafts;
  for (const std::uint32_t c : base.childless()) {
    const bool full = cells_[c].level == base.finest() && cells_[c].points.size() > capacity;
    if (deepen && full) grafts.push_back({c, {}});
  }
#pragma omp parallel for schedule(dynamic) if (grafts.size() > 1)
  for (std::size_t g = 0; g < grafts.size(); ++g) {
    grafts[g].tree = grown(frames_[grafts[g].cell], cells_[grafts[g].cell].points, points, units,
                           capacity, builder);
  }
  if (!grafts.empty()) {
    append(grafts);
    set_frames(base.domain(), units);
  }
  rank_childless();
}

/// A tree over some points of the order, in the frame of their cell.
tree::Quadtree DeepTree::grown(const Frame& at, tree::Range own, tree::Points points,
                               const Units& units, std::uint32_t capacity, Builder builder) const {
  constexpr std::uint32_t ahead = 32;  // places to ask memory for in advance
  std::vector<double> x(own.size()), y(own.size());
  for (std::uint32_t j = own.first; j < own.last; ++j) {
    const std::uint32_t next = order_[std::min(j + ahead, own.last - 1)];
    __builtin_prefetch(&points.x[next]);
    __builtin_prefetch(&points.y[next]);
    const auto local = [&](double value, double centre, double rest) {
      return std::clamp(((units.position(value) - centre) - rest) / at.side, -0.5, 0.5);
    };
    x[j - own.first] = local(points.x[order_[j]], at.x, at.x_rest);
    y[j - own.first] = local(points.y[order_[j]], at.y, at.y_rest);
  }
  return build(tree::morton_order({x, y}, {-0.5, -0.5, 1.0}), tree::crowded(capacity), builder);
}

double DeepTree::side(int level) const {
  return std::ldexp(frames_[0].side, -level);
}

void DeepTree::take(const tree::Quadtree& base) {
  const auto cells = base.cells();
  cells_.resize(cells.size());
#pragma omp parallel for schedule(static) if (cells.size() > alone)
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const tree::Cell& from = cells[c];
    cells_[c] = {from.level, static_cast<int>(from.key & 3), from.parent, from.children,
                 from.points};
  }
  for (int level = 0; level <= base.depth(); ++level) {
    level_first_.push_back(base.level(level).last);
  }
}

/// Cells of a graft come after all cells of coarser levels, graft by graft.
void DeepTree::append(const std::vector<Graft>& grafts) {
  const int finest = depth();
  int deepest = 0;
  for (const Graft& graft : grafts) {
    const std::uint32_t first = cells_[graft.cell].points.first;
    const std::vector<std::uint32_t> before(order_.begin() + first,
                                            order_.begin() + cells_[graft.cell].points.last);
    for (std::size_t j = 0; j < before.size(); ++j) {
      order_[first + j] = before[graft.tree.order()[j]];
    }
    deepest = std::max(deepest, graft.tree.depth());
  }
  // shift[g] turns numbers of the level above in graft g into numbers here
  std::vector<std::int64_t> shift(grafts.size());
  for (std::size_t g = 0; g < grafts.size(); ++g) shift[g] = grafts[g].cell;
  for (int level = 1; level <= deepest; ++level) {
    for (std::size_t g = 0; g < grafts.size(); ++g) {
      const tree::Quadtree& graft = grafts[g].tree;
      const tree::Range range = graft.level(level);
      if (range.empty()) continue;
      const std::int64_t above = shift[g];
      shift[g] = static_cast<std::int64_t>(cells_.size()) - range.first;
      const std::uint32_t points = cells_[grafts[g].cell].points.first;
      for (std::uint32_t c = range.first; c < range.last; ++c) {
        const tree::Cell& from = graft.cells()[c];
        const auto parent = static_cast<std::int32_t>(from.parent + above);
        const auto number = static_cast<std::uint32_t>(cells_.size());
        tree::Range& family = cells_[parent].children;
        if (family.empty()) family.first = number;
        family.last = number + 1;
        cells_.push_back({finest + level,
                          static_cast<int>(from.key & 3),
                          parent,
                          {},
                          {from.points.first + points, from.points.last + points}});
      }
    }
    level_first_.push_back(static_cast<std::uint32_t>(cells_.size()));
  }
}

void DeepTree::set_frames(const tree::Domain& domain, const Units& units) {
  frames_.resize(cells_.size());
  const double half = domain.side / 2 * units.per_length;
  Frame& root = frames_[0];
  root.side = 2 * half;
  two_sum(domain.x0 * units.per_length, half, root.x, root.x_rest);
  two_sum(domain.y0 * units.per_length, half, root.y, root.y_rest);
  for (int l = 1; l <= depth(); ++l) {
    const tree::Range range = level(l);
#pragma omp parallel for schedule(static) if (range.size() > alone)
    for (std::uint32_t c = range.first; c < range.last; ++c) {
      frames_[c] = child_frame(frames_[cells_[c].parent], cells_[c].quadrant);
    }
  }
}

/// First the number of childless cells under each cell, from the leaves up; then the place of the
/// first of them, from the root down.
void DeepTree::rank_childless() {
  std::vector<std::uint32_t> place(cells_.size(), 0);
  for (std::size_t c = cells_.size(); c-- > 0;) {
    place[c] += cells_[c].childless();
    if (cells_[c].parent >= 0) place[cells_[c].parent] += place[c];
  }
  childless_.resize(place[0]);
  place[0] = 0;
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    std::uint32_t next = place[c];
    if (cells_[c].childless()) childless_[next] = c;
    for (std::uint32_t k = cells_[c].children.first; k < cells_[c].children.last; ++k) {
      next += std::exchange(place[k], next);
    }
  }
}

std::size_t DeepTree::bytes() const {
  return cells_.capacity() * (sizeof(DeepCell) + sizeof(Frame)) +
         sizeof(std::uint32_t) *
             (level_first_.capacity() + childless_.capacity() + order_.capacity());
}

}  // namespace vortree::fmm
