#include "fmm/lists/interactions.hpp"

#include <algorithm>
#include <cmath>

#include "fmm/tuning.hpp"

namespace vortree::fmm {
namespace {

/// Sources that cost as much, summed directly, as a series of so many terms.
std::uint32_t equally_dear(int terms) {
  return static_cast<std::uint32_t>(series_start + terms / terms_a_source);
}

/// A stack deep enough for a walk to the finest level, four children at a time.
class Open {
 public:
  void push(std::uint32_t cell) { cells_[size_++] = cell; }
  std::uint32_t pop() { return cells_[--size_]; }
  [[nodiscard]] bool empty() const { return size_ == 0; }

 private:
  std::uint32_t cells_[4 * (tree::max_level + 1)];
  int size_ = 0;
};

struct Meeting {
  bool hidden;     // no core shows
  bool converges;  // the series does, at squared_ratio
  double squared_ratio, per_distance2;
};

Meeting meet(const CellShapes& shapes, std::size_t cell, const TargetBox& target,
             const Acceptance& acceptance) {
  const double dx = std::max(0.0, std::abs(shapes.x[cell] - target.x) - target.half_x);
  const double dy = std::max(0.0, std::abs(shapes.y[cell] - target.y) - target.half_y);
  const double gap_x = std::max(0.0, dx - shapes.half_x[cell]);
  const double gap_y = std::max(0.0, dy - shapes.half_y[cell]);
  const double gap2 = gap_x * gap_x + gap_y * gap_y, distance2 = dx * dx + dy * dy;
  const double radius2 = shapes.radius[cell] * shapes.radius[cell];
  const double per_distance2 = 1.0 / distance2;
  return {.hidden = gap2 >= acceptance.squared_reach(shapes.core[cell], target.core),
          .converges = radius2 < acceptance.order.squared_ratio() * distance2,
          .squared_ratio = radius2 * per_distance2,
          .per_distance2 = per_distance2};
}

void open_children(const tree::Cell& cell, Open& open) {
  for (std::uint32_t k = cell.children.last; k-- > cell.children.first;) open.push(k);
}

void look(const tree::Quadtree& tree, const CellShapes& shapes, const TargetBox& leaf,
          const Acceptance& acceptance, std::uint32_t c, Open& open, Interactions& found) {
  const tree::Cell& cell = tree.cells()[c];
  const Meeting meeting = meet(shapes, c, leaf, acceptance);
  if (meeting.hidden && meeting.converges) {
    const int terms = acceptance.order.terms(meeting.squared_ratio);
    if (cell.points.size() > equally_dear(terms)) {
      found.series.push_back({c, terms, meeting.per_distance2});
    } else {
      found.bare.push_back(cell.points);
    }
  } else if (cell.childless()) {
    (meeting.hidden ? found.bare : found.cored).push_back(cell.points);
  } else {
    open_children(cell, open);
  }
}

}  // namespace

void find_shared(const tree::Quadtree& tree, const CellShapes& shapes, const TargetBox& block,
                 const Acceptance& acceptance, SharedInteractions& found) {
  found.clear();
  if (tree.cells().empty()) return;
  const double size = std::hypot(block.half_x, block.half_y);
  Open open;
  open.push(0);
  while (!open.empty()) {
    const std::uint32_t c = open.pop();
    const tree::Cell& cell = tree.cells()[c];
    const Meeting meeting = meet(shapes, c, block, acceptance);
    const bool series = meeting.hidden && meeting.converges;
    const int terms = series ? acceptance.order.terms(meeting.squared_ratio) : 0;
    if (series && cell.points.size() > equally_dear(terms)) {
      found.series.push_back({c, terms, meeting.per_distance2});
    } else if (series || cell.childless() || shapes.radius[c] <= size) {
      found.waiting.push_back(c);
    } else {
      open_children(cell, open);
    }
  }
}

void find_interactions(const tree::Quadtree& tree, const CellShapes& shapes, const TargetBox& leaf,
                       const Acceptance& acceptance, std::span<const std::uint32_t> waiting,
                       Interactions& found) {
  found.clear();
  Open open;
  for (const std::uint32_t c : waiting) {
    look(tree, shapes, leaf, acceptance, c, open, found);
    while (!open.empty()) look(tree, shapes, leaf, acceptance, open.pop(), open, found);
  }
}

}  // namespace vortree::fmm
