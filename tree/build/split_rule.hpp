#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "tree/order/points.hpp"

namespace vortree::tree {

/// A square cell as a rule sees it: its level, its side [m] and its run of points in Morton order.
struct Block {
  int level = 0;
  double side = 0;
  Range points;
};

/// The one question that shapes a tree: must this block split?
///
/// A rule must be a function of the block alone, and monotone: if a block need not split, none of
/// the blocks inside it must. Then the tree is unique, whichever way it is walked. A block always
/// holds points. Of large trees several threads may ask at once.
using SplitRule = std::function<bool(const Block&)>;

/// The rule that crowded() gives. Builders know it by its type and then ask it directly.
struct CrowdedRule {
  std::uint32_t n_ctrl;
  [[nodiscard]] bool operator()(const Block& block) const { return block.points.size() > n_ctrl; }
};

/// A block must split if it holds more than n_ctrl points. What the FMM asks.
///
/// cost    O(1) a question
/// throws  std::invalid_argument if n_ctrl is 0
/// source  Huang, Huang, Xu & Hu, Thermal Science 16 (2012), step 2: "no more than N_ctrl" in a
/// cell
[[nodiscard]] SplitRule crowded(std::uint32_t n_ctrl);

/// A block must split if half its side still spans the smallest reach inside:
///
///   side / 2 >= min_{j in block} reach_j
///
/// so that every point lies in a childless cell whose side is less than twice the smallest reach in
/// it (or of the finest level). With the largest reach instead, the rule would not be monotone.
///
/// reach   one per point [m], in Morton order (reach[j] belongs to point order.index[j]); copied
/// cost    O(log n) a question; 8.6 bytes a point
/// throws  std::invalid_argument naming the first reach that is negative or not finite; when asked,
///         if a block has points beyond the reaches given
/// source  Khorasanizade & Sousa 2019, quadtree cells grid: particles in cells of their own size
[[nodiscard]] SplitRule roomy(std::span<const double> reach);

/// The same with one reach for all points [m]: no cell is cut into children narrower than that.
[[nodiscard]] SplitRule roomy(double reach);

/// A block must split if a or b says so. Monotone if both are.
[[nodiscard]] SplitRule either(SplitRule a, SplitRule b);

/// A block must split if both a and b say so: it may rest when one is content. Monotone if both
/// are.
[[nodiscard]] SplitRule both(SplitRule a, SplitRule b);

}  // namespace vortree::tree
