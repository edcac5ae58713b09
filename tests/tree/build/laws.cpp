#include "tree/build/laws.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace vortree::test {

using tree::Block;
using tree::Cell;
using tree::Quadtree;

namespace {

std::string broken_storage(const Quadtree& tree, tree::Points points) {
  std::vector<bool> seen(points.size(), false);
  for (const std::uint32_t i : tree.order()) {
    if (i >= points.size() || seen[i]) return "the order is a permutation";
    seen[i] = true;
  }
  if (tree.order().size() != points.size()) return "every point is in the order";
  if (!std::is_sorted(tree.keys().begin(), tree.keys().end())) return "codes ascend";
  if (points.size() == 0) {
    return tree.cells().empty() && tree.childless().empty() && tree.depth() == -1
               ? ""
               : "no points, no cells";
  }
  std::uint32_t next = 0;
  for (int l = 0; l <= tree.depth(); ++l) {
    if (tree.level(l).first != next || tree.level(l).empty()) return "levels follow one another";
    next = tree.level(l).last;
    for (std::uint32_t c = tree.level(l).first; c < next; ++c) {
      if (tree.cells()[c].level != l) return "a level holds its own cells only";
      if (c > tree.level(l).first && tree.cells()[c - 1].key >= tree.cells()[c].key)
        return "Morton order within a level";
    }
  }
  return next == tree.cells().size() && tree.level(tree.depth() + 1).empty()
             ? ""
             : "levels hold all cells";
}

std::string broken_kinship(const Quadtree& tree) {
  const auto cells = tree.cells();
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    const Cell& cell = cells[c];
    if (cell.points.empty()) return "no cell is empty";
    if ((cell.parent == -1) != (c == 0)) return "the root alone has no parent";
    if (cell.parent >= 0) {
      const Cell& parent = cells[cell.parent];
      if (c < parent.children.first || c >= parent.children.last) return "a parent knows its child";
      if (cell.level != parent.level + 1 || cell.key / 4 != parent.key)
        return "a child lies in its parent";
    }
    if (cell.childless()) continue;
    std::uint32_t next = cell.points.first;
    for (std::uint32_t k = cell.children.first; k < cell.children.last; ++k) {
      if (cells[k].parent != static_cast<std::int32_t>(c)) return "a child knows its parent";
      if (cells[k].points.first != next) return "children partition their parent's points";
      next = cells[k].points.last;
    }
    if (next != cell.points.last) return "children hold all points of their parent";
  }
  return "";
}

std::string broken_rule(const Quadtree& tree, const tree::SplitRule& must_split) {
  for (const Cell& cell : tree.cells()) {
    const bool must = must_split(Block{cell.level, tree.side(cell.level), cell.points});
    if (cell.level > tree.finest()) return "no cell is below the finest level";
    if (cell.childless() && must && cell.level < tree.finest())
      return "a childless cell obeys the rule";
    if (!cell.childless() && !must) return "every cell with children had to split";
  }
  std::uint32_t next = 0;
  for (const std::uint32_t c : tree.childless()) {
    if (!tree.cells()[c].childless()) return "the childless are childless";
    if (tree.cells()[c].points.first != next) return "childless cells partition the points";
    next = tree.cells()[c].points.last;
  }
  return next == tree.order().size() ? "" : "childless cells hold all points";
}

double spacing(double v) {
  return std::nextafter(std::abs(v), std::numeric_limits<double>::infinity()) - std::abs(v);
}

bool within(double v, double centre, double half, double finest_side) {
  return std::abs(v - centre) <= half + 0x1p-20 * finest_side + spacing(centre);
}

std::string broken_geometry(const Quadtree& tree, tree::Points points) {
  const double slack = tree.side(tree::max_level);
  for (const Cell& cell : tree.cells()) {
    const tree::Centre centre = tree.centre(cell);
    const double half = tree.side(cell.level) / 2;
    for (std::uint32_t j = cell.points.first; j < cell.points.last; ++j) {
      const std::uint32_t i = tree.order()[j];
      if (!within(points.x[i], centre.x, half, slack) ||
          !within(points.y[i], centre.y, half, slack))
        return "points lie in their cells";
    }
    if (cell.parent < 0) continue;
    const tree::Centre parent = tree.centre(tree.cells()[cell.parent]);
    const double dx = std::abs(centre.x - parent.x), dy = std::abs(centre.y - parent.y);
    if (std::abs(dx - half) > spacing(centre.x) + spacing(parent.x) ||
        std::abs(dy - half) > spacing(centre.y) + spacing(parent.y))
      return "a child's centre is a quarter side from its parent's";
  }
  return "";
}

}  // namespace

std::string broken_law(const Quadtree& tree, const tree::SplitRule& must_split,
                       tree::Points points) {
  for (const std::string& broken : {broken_storage(tree, points), broken_kinship(tree),
                                    broken_rule(tree, must_split), broken_geometry(tree, points)}) {
    if (!broken.empty()) return broken;
  }
  return "";
}

}  // namespace vortree::test
