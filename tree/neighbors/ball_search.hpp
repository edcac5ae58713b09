#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tree/base/buffer.hpp"
#include "tree/build/quadtree.hpp"
#include "tree/neighbors/pair_list.hpp"
#include "tree/neighbors/periodic_box.hpp"
#include "tree/order/points.hpp"

namespace vortree::tree {

/// Points near any place, which need not be one of them: of probes, of walls, of another cloud.
///
///   point j is near place p if  dx dx + dy dy < r_p r_p,   dx = x_j - x_p,   dy = y_j - y_p,
///
/// by the very rule of lists (`own`, pair_rule.hpp): a point at the place itself is near.
///
/// In a periodic box dx and dy are those of the nearest images (periodic_box.hpp), and a place
/// outside stands for its image inside.
///
/// A tree of the points is walked from its root; into no cell whose points' bounding box has no
/// place within the radius. Rounding is monotone, so the box needs no margin.
///
/// cost    O(n) once, 20 bytes a point and 64 a cell; O(log n) a place, and what is found. Places
///         are shared among the threads
class BallSearch {
 public:
  /// throws  std::invalid_argument if sizes differ, if there are 2^31 points or more, or naming the
  ///         first coordinate that is not finite or exceeds largest_coordinate (points.hpp), or as
  ///         check_inside() does
  explicit BallSearch(Points points, const PeriodicBox& box = {});

  /// Lists the points near every place, in ascending order of their numbers.
  ///
  /// radius  one for each place [m]
  /// rows    one for each place; overwritten
  /// throws  std::invalid_argument if sizes differ, or naming the first coordinate of a place that
  ///         is not finite or exceeds largest_coordinate, or the first radius that is negative or
  ///         not finite; std::length_error if there are more than rows.most points in all rows
  void list(Points places, std::span<const double> radius, PairList& rows) const;

  /// Appends the points near one place, in the order of the tree.
  ///
  /// x, y, radius   as above, and in the box
  void find(double x, double y, double radius, std::vector<std::int32_t>& found) const;

 private:
  struct Box {
    double left, right, low, high;
  };

  template <class Distance>
  void walk(const Distance& distance, double radius, std::vector<std::int32_t>& found) const;

  PeriodicBox box_;
  Quadtree tree_;
  Buffer<double> x_, y_;  // in the order of the tree
  std::vector<Box> boxes_;
};

}  // namespace vortree::tree
