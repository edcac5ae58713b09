#include "tree/build/build_forward.hpp"

#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tree/base/parallel.hpp"
#include "tree/build/assembly.hpp"
#include "tree/build/search_kernel.hpp"

namespace vortree::tree {

namespace {

// Where child q of a family ends, if it ends inside `within`.
std::uint32_t end_of_child(std::span<const MortonKey> keys, Range within, MortonKey child,
                           int level) {
  return kernel::lower_bound(keys, within, first_descendant(child + 1, level));
}

// Appends the occupied children of a cell and notes which of them they are.
void split(std::vector<Cell>& cells, std::uint32_t parent, std::span<const MortonKey> keys,
           std::vector<Cell>& children) {
  const Range points = cells[parent].points;
  const MortonKey family = cells[parent].key << 2;
  const int level = cells[parent].level + 1;
  const std::uint32_t middle = end_of_child(keys, points, family + 1, level);
  const std::uint32_t ends[] = {end_of_child(keys, {points.first, middle}, family, level), middle,
                                end_of_child(keys, {middle, points.last}, family + 2, level),
                                points.last};
  const auto eldest = static_cast<std::uint32_t>(children.size());
  std::uint32_t first = points.first;
  for (MortonKey q = 0; q < 4; first = ends[q++]) {
    if (first < ends[q]) {
      children.push_back(
          {family + q, level, static_cast<std::int32_t>(parent), {}, {first, ends[q]}});
    }
  }
  cells[parent].children = {eldest, static_cast<std::uint32_t>(children.size())};
}

template <class Rule>
class Grower {
 public:
  Grower(const MortonOrder& order, const Rule& must_split, std::size_t pieces)
      : order_(order), must_split_(must_split), pieces_(pieces) {}

  [[nodiscard]] Assembly run() && {
    const auto n = static_cast<std::uint32_t>(order_.keys.size());
    if (n > 0) cells_.push_back({0, 0, -1, {}, {0, n}});
    std::vector<std::uint32_t> level_first{0};
    for (std::uint32_t first = 0; first < cells_.size(); first = level_first.back()) {
      const Range level{first, static_cast<std::uint32_t>(cells_.size())};
      level_first.push_back(level.last);
      add_children(level);
    }
    return {std::move(cells_), std::move(level_first), {}};
  }

 private:
  // Every piece of a level gathers its children; then they move in behind the level.
  void add_children(Range level) {
    const std::size_t pieces = level.size() >= cells_a_piece * pieces_ ? pieces_ : 1;
    std::vector<std::vector<Cell>> children(pieces);
    for_each_piece(pieces, [&](std::size_t p) {
      const Range part = piece(level.size(), p, pieces);
      for (std::uint32_t c = level.first + part.first; c < level.first + part.last; ++c) {
        if (must_split(cells_[c])) split(cells_, c, order_.keys, children[p]);
      }
    });
    for (std::size_t p = 0; p < pieces; ++p) {
      const Range part = piece(level.size(), p, pieces);
      const auto before = static_cast<std::uint32_t>(cells_.size());
      for (std::uint32_t c = level.first + part.first; c < level.first + part.last; ++c) {
        Range& own = cells_[c].children;
        if (!own.empty()) own = {own.first + before, own.last + before};
      }
      cells_.insert(cells_.end(), children[p].begin(), children[p].end());
    }
  }

  [[nodiscard]] bool must_split(const Cell& cell) const {
    return cell.level < order_.finest &&
           must_split_(Block{cell.level, order_.domain.cell_side(cell.level), cell.points});
  }

  const MortonOrder& order_;
  const Rule& must_split_;
  std::size_t pieces_;
  std::vector<Cell> cells_;
};

}  // namespace

Assembly grow_forward(const MortonOrder& order, const SplitRule& must_split, std::size_t pieces) {
  const auto* crowded = must_split.target<CrowdedRule>();
  Assembly grown =
      crowded ? Grower(order, *crowded, pieces).run() : Grower(order, must_split, pieces).run();
  grown.childless = rank_childless(grown.cells);
  return grown;
}

Quadtree build_forward(MortonOrder order, const SplitRule& must_split) {
  if (!must_split) {
    throw std::invalid_argument("build_forward: the split rule is empty");
  }
  check_order(order);
  Assembly grown = grow_forward(order, must_split, pieces_of(order.keys.size()));
  return std::move(grown).over(std::move(order));
}

}  // namespace vortree::tree
