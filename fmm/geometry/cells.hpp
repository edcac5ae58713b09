#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "tree/base/memory.hpp"
#include "tree/build/quadtree.hpp"

namespace vortree::fmm {

/// Points in Morton order, in Units, with their squared cores.
struct SortedPoints {
  Reals x, y, core;
  [[nodiscard]] std::size_t size() const { return x.size(); }
};

struct BoundingBox {
  double left, right, bottom, top;

  void include(const BoundingBox& other) {
    left = std::min(left, other.left), right = std::max(right, other.right);
    bottom = std::min(bottom, other.bottom), top = std::max(top, other.top);
  }
};

/// The cells of a tree, shrunk to the points they hold: a bounding box about an expansion centre,
/// the distance from there to the outermost point, and the largest squared core, which is carried
/// upward so that a parent knows the widest blob below it.
struct CellShapes {
  Reals x, y;            // middle of the bounding box
  Reals half_x, half_y;  // half its sides
  Reals radius;          // no point is farther from the middle
  Reals core;            // the largest squared core inside

  CellShapes() = default;
  CellShapes(const tree::Quadtree& tree, const SortedPoints& points);
  [[nodiscard]] std::size_t size() const { return x.size(); }

 private:
  void set(std::size_t cell, const BoundingBox& box, double largest_core);
};

}  // namespace vortree::fmm
