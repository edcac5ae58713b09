#pragma once

#include "tree/build/quadtree.hpp"
#include "tree/build/split_rule.hpp"

namespace vortree::tree {

/// Builds a tree from root to leaf: level by level, every cell that must split is cut into its
/// occupied children by binary search of their ends in the sorted codes.
///
///   child q of (key, l) holds the codes from (4 key + q) 4^(30-l) on that are below
///   (4 key + q + 1) 4^(30-l),   q = 0..3
///
/// A block at level order.finest never splits. Equal to build_reverse for every monotone rule.
///
/// cost    one question to the rule and O(log n) for each cell
/// threads OpenMP, level by level; the result is the same for any number
/// throws  std::invalid_argument if the rule is empty or keys and index of the order differ in size
/// source  Huang, Huang, Xu & Hu, Thermal Science 16 (2012), steps 1-3
[[nodiscard]] Quadtree build_forward(MortonOrder order, const SplitRule& must_split);

}  // namespace vortree::tree
