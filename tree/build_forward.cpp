#include "tree/build_forward.hpp"

#include <stdexcept>
#include <utility>
#include <vector>

#include "tree/search_kernel.hpp"

namespace vortree::tree {

namespace {

// Where child q of a family ends, if it ends inside `within`.
std::uint32_t end_of_child(const std::vector<Key>& keys, Range within, Key child, int level) {
  return kernel::lower_bound(keys, within, first_descendant(child + 1, level));
}

void split(std::uint32_t parent, const std::vector<Key>& keys, std::vector<Cell>& cells) {
  const Range points = cells[parent].points;
  const Key family = cells[parent].key << 2;
  const int level = cells[parent].level + 1;
  const std::uint32_t middle = end_of_child(keys, points, family + 1, level);
  const std::uint32_t ends[] = {end_of_child(keys, {points.first, middle}, family, level), middle,
                                end_of_child(keys, {middle, points.last}, family + 2, level),
                                points.last};
  const auto eldest = static_cast<std::uint32_t>(cells.size());
  std::uint32_t first = points.first;
  for (Key q = 0; q < 4; first = ends[q++]) {
    if (first < ends[q]) {
      cells.push_back({family + q, level, static_cast<std::int32_t>(parent), {}, {first, ends[q]}});
    }
  }
  cells[parent].children = {eldest, static_cast<std::uint32_t>(cells.size())};
}

}  // namespace

Quadtree build_forward(MortonOrder order, const SplitRule& must_split) {
  if (!must_split) {
    throw std::invalid_argument("build_forward: the split rule is empty");
  }
  std::vector<Cell> cells;
  if (!order.keys.empty()) {
    cells.push_back({0, 0, -1, {}, {0, static_cast<std::uint32_t>(order.keys.size())}});
  }
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    const Block block{cells[c].level, order.domain.cell_side(cells[c].level), cells[c].points};
    if (block.level < order.finest && must_split(block)) {
      split(c, order.keys, cells);
    }
  }
  return Quadtree(std::move(order), std::move(cells));
}

}  // namespace vortree::tree
