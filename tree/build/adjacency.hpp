#pragma once

#include <cstdint>

#include "tree/build/quadtree.hpp"

namespace vortree::tree {

/// True if the closed squares of two cells share at least a corner. The cells may be of any levels;
/// a cell is adjacent to itself, to its ancestors and to its descendants.
///
/// cost    O(1), integers only: no rounding
/// source  Carrier, Greengard & Rokhlin, SIAM J. Sci. Stat. Comput. 9 (1988), lists U, V, W, X
[[nodiscard]] constexpr bool adjacent(const Cell& a, const Cell& b) {
  const int fine = a.level > b.level ? a.level : b.level;
  const int rise_a = fine - a.level, rise_b = fine - b.level;
  const GridCell ga = decode(a.key), gb = decode(b.key);
  const auto touch = [=](std::uint64_t ia, std::uint64_t ib) {
    return ia << rise_a <= (ib + 1) << rise_b && ib << rise_b <= (ia + 1) << rise_a;
  };
  return touch(ga.ix, gb.ix) && touch(ga.iy, gb.iy);
}

}  // namespace vortree::tree
