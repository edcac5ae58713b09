#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tree/build/quadtree.hpp"
#include "tree/build/split_rule.hpp"

namespace vortree::tree {

/// What a builder has made, and vouches for: nothing is checked or derived again.
///
/// level_first   number of the first cell of every level, and of all cells
/// childless     numbers of the childless cells in Morton order
struct Assembly {
  std::vector<Cell> cells;
  std::vector<std::uint32_t> level_first, childless;

  [[nodiscard]] Quadtree over(MortonOrder order) &&;
};

/// A childless cell: the first of its points, its level, and the level at which it meets the point
/// before, -1 if there is none.
struct Leaf {
  std::uint32_t first;
  std::int16_t met, level;
};

/// Childless cells, found piece by piece: those of a piece are in Morton order and come after those
/// of the pieces before.
using LeavesByPiece = std::vector<std::vector<Leaf>>;

/// The tree with the given childless cells: walking them in Morton order, each begins new cells
/// from just below the level at which it meets its predecessor down to its own; all others of its
/// ancestors are there already. One that meets nobody begins at a root.
///
/// cost    O(cells); every piece by a thread
[[nodiscard]] Assembly assemble(std::span<const MortonKey> keys, const LeavesByPiece& leaves);

/// What build_forward and build_reverse return, by so many pieces, each the work of one thread. The
/// number makes no difference.
[[nodiscard]] Assembly grow_forward(const MortonOrder& order, const SplitRule& must_split,
                                    std::size_t pieces);
[[nodiscard]] Assembly grow_reverse(const MortonOrder& order, const SplitRule& must_split,
                                    std::size_t pieces);

/// Many trees at once, each over a run of points of its own and a domain of its own, down to level
/// 31. Cells of all are numbered together, level by level and tree by tree within a level; a root
/// for each run makes level 0.
///
/// keys   ascending within each run
/// runs   not empty, one after the other, together all keys
[[nodiscard]] Assembly grow_forest(std::span<const MortonKey> keys, std::span<const Range> runs,
                                   CrowdedRule must_split, std::size_t pieces);

/// Numbers of the childless cells in Morton order.
[[nodiscard]] std::vector<std::uint32_t> rank_childless(const std::vector<Cell>& cells);

/// The level of the smallest cell that holds both a point and the one before it; -1 if there is no
/// such cell.
[[nodiscard]] inline int meeting_level(std::span<const MortonKey> keys, std::uint32_t point) {
  return point == 0 || point == keys.size() ? -1 : common_level(keys[point - 1], keys[point]);
}

/// Refuses an order of which no tree can be grown.
///
/// throws  std::invalid_argument if keys and index differ in size, or if finest is not a level
void check_order(const MortonOrder& order);

}  // namespace vortree::tree
