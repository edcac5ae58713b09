#pragma once

#include <cstdint>

#include "tree/base/memory.hpp"
#include "tree/order/morton.hpp"
#include "tree/order/points.hpp"

namespace vortree::tree {

/// Points put in Morton order.
///
/// keys    n level-31 codes, ascending; the bits below level `finest` are zero
/// index   n input positions: keys[j] belongs to point index[j]; equal keys keep their input order
struct MortonOrder {
  Domain domain;
  int finest = max_level;
  Unwritten<MortonKey> keys;
  Unwritten<std::uint32_t> index;
  bool operator==(const MortonOrder&) const = default;
};

/// Finds the cell of level `finest` of every point and sorts the points by its Morton code.
///
///   ix = min(floor((x - x0) 2^31 / side), 2^31 - 1), its last 31 - finest bits cleared; same in y
///
/// The top and right edges of the domain belong to the last cells. Monotone in x and in y. A point
/// lies in the closed square of its cell but for rounding: at most 2^-20 of a cell of level 31 (and
/// half the spacing of doubles where that is wider).
///
/// cost    O(n): an encoding pass and a radix sort; 24 bytes a point at the peak, of which 12 stay
/// throws  std::invalid_argument if the sizes of x and y differ, if there are 2^32 - 1 points or
///         more, if finest is not in 0..31, if the domain is not a finite square with
///         side >= 2^-900, or naming the first point (and its index) that is outside the domain or
///         not finite
/// source  Huang, Huang, Xu & Hu, Thermal Science 16 (2012), steps 4-5
[[nodiscard]] MortonOrder morton_order(Points points, const Domain& domain, int finest = max_level);

}  // namespace vortree::tree
