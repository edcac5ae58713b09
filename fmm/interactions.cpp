#include "fmm/interactions.hpp"

#include <algorithm>
#include <cmath>

namespace vortree::fmm {
namespace {

/// Sources that cost as much, summed directly, as a series of so many terms.
std::uint32_t equally_dear(int terms) {
  return static_cast<std::uint32_t>(3 + terms / 2);
}

struct Meeting {
  double gap2;       // between the boxes
  double distance2;  // from the expansion centre to the target box
};

Meeting meet(const CellShapes& shapes, std::size_t cell, const TargetBox& target) {
  const double dx = std::max(0.0, std::abs(shapes.x[cell] - target.x) - target.half_x);
  const double dy = std::max(0.0, std::abs(shapes.y[cell] - target.y) - target.half_y);
  const double gap_x = std::max(0.0, dx - shapes.half_x[cell]);
  const double gap_y = std::max(0.0, dy - shapes.half_y[cell]);
  return {gap_x * gap_x + gap_y * gap_y, dx * dx + dy * dy};
}

}  // namespace

void find_interactions(const tree::Quadtree& tree, const CellShapes& shapes,
                       const TargetBox& target, const Acceptance& acceptance, Interactions& found) {
  found.clear();
  const auto cells = tree.cells();
  if (cells.empty()) return;
  std::uint32_t open[4 * (tree::max_level + 1)];
  int waiting = 0;
  open[waiting++] = 0;
  while (waiting > 0) {
    const std::uint32_t c = open[--waiting];
    const tree::Cell& cell = cells[c];
    const Meeting meeting = meet(shapes, c, target);
    const bool bare = meeting.gap2 >= acceptance.squared_reach(shapes.core[c], target.core);
    const double radius2 = shapes.radius[c] * shapes.radius[c];
    if (bare && radius2 < acceptance.order.squared_ratio() * meeting.distance2) {
      const int terms = acceptance.order.terms(radius2 / meeting.distance2);
      if (cell.points.size() <= equally_dear(terms)) {
        found.bare.push_back(cell.points);
      } else {
        found.series.push_back({c, terms});
      }
    } else if (cell.childless()) {
      (bare ? found.bare : found.cored).push_back(cell.points);
    } else {
      for (std::uint32_t k = cell.children.last; k-- > cell.children.first;) open[waiting++] = k;
    }
  }
}

}  // namespace vortree::fmm
