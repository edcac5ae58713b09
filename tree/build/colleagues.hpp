#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tree/build/quadtree.hpp"

namespace vortree::tree {

/// The 3 x 3 cells of one level around a cell, row by row from the lower left; number 4 is the cell
/// itself. -1 where the tree has no cell of that level.
using Colleagues = std::array<std::int32_t, 9>;

/// The colleagues of every cell: read off the children of its parent's colleagues, level by level.
///
/// colleagues   one for each cell; overwritten
/// cost         O(cells), no searches
/// source       Carrier, Greengard & Rokhlin, SIAM J. Sci. Stat. Comput. 9 (1988)
void find_colleagues(const Quadtree& tree, std::vector<Colleagues>& colleagues);

/// The same of cells of any depth, parents before their children; of a key only the last two bits,
/// the quarter of the parent, are looked at.
void find_colleagues(std::span<const Cell> cells, std::vector<Colleagues>& colleagues);

}  // namespace vortree::tree
