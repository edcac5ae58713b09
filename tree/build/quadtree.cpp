#include "tree/build/quadtree.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "tree/build/assembly.hpp"

namespace vortree::tree {

namespace {

bool inside(const Cell& cell, std::span<const MortonKey> keys) {
  return !cell.points.empty() && cell.points.last <= keys.size() &&
         ancestor(keys[cell.points.first], cell.level) == cell.key &&
         ancestor(keys[cell.points.last - 1], cell.level) == cell.key;
}

bool is_child(const Cell& cell, const Cell& parent) {
  return cell.level == parent.level + 1 && cell.key >> 2 == parent.key;
}

// Walks the cells as a queue: the children of each cell must be the next run that nobody has
// claimed.
class TreeCheck {
 public:
  TreeCheck(const MortonOrder& order, const std::vector<Cell>& cells)
      : order_(order), cells_(cells) {}

  void run() const {
    if (cells_.empty() && order_.keys.empty()) {
      return;
    }
    if (cells_.size() > std::numeric_limits<std::int32_t>::max()) {
      throw std::invalid_argument("Quadtree: " + std::to_string(cells_.size()) +
                                  " cells; at most 2^31 - 1 fit");
    }
    const bool rooted =
        !cells_.empty() && cells_[0].parent == -1 && cells_[0].level == 0 &&
        cells_[0].points == Range{0, static_cast<std::uint32_t>(order_.keys.size())};
    demand(rooted, 0);
    std::uint32_t unclaimed = 1;
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
      demand(c < unclaimed && cells_[c].level <= order_.finest && inside(cells_[c], order_.keys),
             c);
      if (!cells_[c].childless()) {
        demand(cells_[c].children.first == unclaimed && cells_[c].children.last <= cells_.size(),
               c);
        check_children(c);
        unclaimed = cells_[c].children.last;
      }
    }
  }

 private:
  void demand(bool claim, std::uint32_t cell) const {
    if (!claim) {
      throw std::invalid_argument("Quadtree: cell " + std::to_string(cell) + " of " +
                                  std::to_string(cells_.size()) + " breaks the tree");
    }
  }

  void check_children(std::uint32_t c) const {
    std::uint32_t next = cells_[c].points.first;
    for (std::uint32_t k = cells_[c].children.first; k < cells_[c].children.last; ++k) {
      demand(cells_[k].parent == static_cast<std::int32_t>(c) && is_child(cells_[k], cells_[c]) &&
                 cells_[k].points.first == next,
             k);
      next = cells_[k].points.last;
    }
    demand(next == cells_[c].points.last, c);
  }

  const MortonOrder& order_;
  const std::vector<Cell>& cells_;
};

std::vector<std::uint32_t> find_levels(const std::vector<Cell>& cells) {
  std::vector<std::uint32_t> first;
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    if (c == 0 || cells[c].level != cells[c - 1].level) {
      first.push_back(c);
    }
  }
  first.push_back(static_cast<std::uint32_t>(cells.size()));
  return first;
}

}  // namespace

Quadtree::Quadtree(MortonOrder order, std::vector<Cell> cells)
    : order_(std::move(order)), cells_(std::move(cells)) {
  check_order(order_);
  TreeCheck(order_, cells_).run();
  level_first_ = find_levels(cells_);
  childless_ = rank_childless(cells_);
}

Range Quadtree::level(int l) const {
  if (l < 0 || l > depth()) {
    return {};
  }
  return {level_first_[l], level_first_[l + 1]};
}

Centre Quadtree::centre(const Cell& cell) const {
  const GridCell grid = decode(cell.key);
  const double half = side(cell.level + 1);
  return {domain().x0 + (2.0 * grid.ix + 1) * half, domain().y0 + (2.0 * grid.iy + 1) * half};
}

}  // namespace vortree::tree
