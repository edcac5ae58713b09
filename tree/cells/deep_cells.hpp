#pragma once

#include <cstdint>
#include <vector>

#include "tree/build/quadtree.hpp"
#include "tree/cells/home_cells.hpp"
#include "tree/neighbors/sorted_particles.hpp"

namespace vortree::tree {

/// Own cells of any depth and the tree over them, for clouds that 29 levels cannot part: clusters
/// far smaller than the whole, nested ones, an outlier far away, lengths near the least double.
///
/// cells    in level order, parents before their children; of a key only the last two bits, the
///          quarter of the parent. Points are own cells, from `level` and `first`
/// level    of every own cell
/// first    where the particles of every own cell begin, and the end of the last
/// sides    of the cells of each level [m], none below 2^-1000
struct DeepCells {
  std::vector<Cell> cells;
  std::vector<std::int16_t> level;
  std::vector<std::uint32_t> first;
  std::vector<double> sides;
};

/// Sorts particles by their own cells on an exact grid (exact_grid.hpp): 29 levels at a time, as
/// home_cells.hpp does; those of a crowded cell of the last of these again, from the level on at
/// which they part. Levels between which nothing happens cost nothing but a cell each.
///
/// placed   in any order; sorted
/// few      a cell with no more particles than this is not split
/// cost     O(n) for 29 levels of a cluster that are not empty
[[nodiscard]] DeepCells deepen(SortedParticles& placed, std::uint32_t few);

/// Do so many particles lie in cells of the last level, though their reaches ask for finer ones,
/// that a search would look at more than some dozens of others for each?
[[nodiscard]] bool too_shallow(const HomeCells& own, const SortedParticles& placed);

}  // namespace vortree::tree
