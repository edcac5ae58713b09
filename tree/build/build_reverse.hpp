#pragma once

#include "tree/build/quadtree.hpp"
#include "tree/build/split_rule.hpp"

namespace vortree::tree {

/// Builds a tree from leaf to root: occupied cells are merged upward, family by family, as long as
/// the parent need not split; only the childless cells are recorded, and their ancestors are
/// assembled from them at the end.
///
/// On sorted codes a family of four is one run, and if a parent need not split, no cell inside it
/// must: so whichever cell comes first in Morton order climbs for its whole family. A climb begins
/// at the level where its predecessor ended if the rule lets it, else further down, the finest
/// level at last. It jumps straight to the level at which its cell meets the next point (xor and
/// count of leading zeros): single chains are not walked level by level. No recursion, and no
/// array of size 4^L.
///
/// crowded(n_ctrl) needs no climb. A cell that begins at point j is crowded if it holds point
/// j + n_ctrl as well, and the childless cell at j does not hold the point before:
///
///   level = 1 + max(common_level(k[j - 1], k[j]), common_level(k[j], k[j + n_ctrl]))
///
/// or the finest level, if that is coarser.
///
/// A block at level order.finest never splits. Equal to build_forward for every monotone rule.
///
/// cost    O(d log n) for each childless cell, d <= order.finest the number of times others join it
///         on the way up (two or three on average), O(log n_ctrl) if the rule is crowded, and O(1)
///         for each cell of the tree
/// threads OpenMP, each from a cell in the middle of the points; the result is the same for any
///         number
/// throws  std::invalid_argument if the rule is empty or keys and index of the order differ in size
/// source  Huang, Huang, Xu & Hu, Thermal Science 16 (2012), steps 4-8, corrected: siblings at
///         level m start at F + {0, 1, 2, 3} 4^(L-m), F a multiple of 4^(L-m+1), and merge up to
///         and including N_ctrl points
[[nodiscard]] Quadtree build_reverse(MortonOrder order, const SplitRule& must_split);

}  // namespace vortree::tree
