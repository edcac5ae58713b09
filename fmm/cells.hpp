#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tree/quadtree.hpp"

namespace vortree::fmm {

/// Points in Morton order, in Units, with their squared cores.
struct SortedPoints {
  std::vector<double> x, y, core;
  [[nodiscard]] std::size_t size() const { return x.size(); }
};

/// The cells of a tree, shrunk to the points they hold: a bounding box about an expansion centre,
/// the distance from there to the outermost point, and the largest squared core, which is carried
/// upward so that a parent knows the widest blob below it.
struct CellShapes {
  std::vector<double> x, y;            // middle of the bounding box
  std::vector<double> half_x, half_y;  // half its sides
  std::vector<double> radius;          // no point is farther from the middle
  std::vector<double> core;            // the largest squared core inside

  CellShapes() = default;
  CellShapes(const tree::Quadtree& tree, const SortedPoints& points);
  [[nodiscard]] std::size_t size() const { return x.size(); }
};

}  // namespace vortree::fmm
