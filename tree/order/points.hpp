#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "tree/base/range.hpp"

namespace vortree::tree {

/// Positions of n points in the plane [m]; x and y are equally long. A view: whoever made the
/// arrays keeps them.
struct Points {
  std::span<const double> x, y;
  [[nodiscard]] std::size_t size() const { return x.size(); }
};

/// The least and the greatest of some numbers.
struct Extent {
  double low, high;
};

/// The square [x0, x0 + side] x [y0, y0 + side] that the cell of level 0 covers [m].
struct Domain {
  double x0 = 0, y0 = 0, side = 1;
  /// Side of a cell of a level: side / 2^level, exact.
  [[nodiscard]] double cell_side(int level) const {
    return side / static_cast<double>(std::uint64_t{1} << level);
  }
  bool operator==(const Domain&) const = default;
};

/// The largest magnitude of a coordinate that a domain is built for: its corners cannot overflow.
inline constexpr double largest_coordinate = 0x1p1020;

/// The smallest square domain, a little enlarged, with its lower left corner at (min x, min y).
///
///   side = max(max x - min x, max y - min y, 2^-21 max(|x|, |y|), 2^-900),
///   rounded up to 20 significant bits, and always by at least 2^-20 of itself
///
/// The enlargement keeps the top and right points inside. The short significand makes the offset of
/// every cell corner and centre, (2i + 1) side / 2^(l+1), exact down to level 31. The third term
/// keeps a cell of level 31 at least as wide as the spacing of doubles: a cluster far from the
/// origin, or a single place, still has cells whose centres can be told apart.
/// Without points, or with all of them at the origin: the unit square.
///
/// cost    O(n)
/// throws  std::invalid_argument if the sizes of x and y differ, or naming the first coordinate
///         (and its index) that is not finite or exceeds largest_coordinate
/// source  Huang, Huang, Xu & Hu, Thermal Science 16 (2012), step 1
[[nodiscard]] Domain enclose(Points points);

/// The same for points, at least one, whose extents are known and in range.
[[nodiscard]] Domain enclose(Extent x, Extent y);

/// The same lower left corner with a side at least `factor` times as long, rounded up as above:
/// lets the cells of some level be of a wished size.
///
/// factor   >= 1
[[nodiscard]] Domain enlarge(const Domain& domain, double factor);

}  // namespace vortree::tree
