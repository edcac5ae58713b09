#pragma once

#include <array>
#include <vector>

#include "sph/cloud/cloud.hpp"

namespace vortree::sph {

/// The rectangle that a flow is computed in [L].
struct OuterBox {
  Vec2 low, high;

  [[nodiscard]] Vec2 size() const { return high - low; }
  /// How far inside a place is; negative outside.
  [[nodiscard]] double depth(Vec2 at) const;
};

/// Nodes on its sides, anticlockwise from the lower left corner on, at steps of about `spacing`;
/// normals of corners are those of the left and right sides.
[[nodiscard]] std::vector<BoundaryNode> box_nodes(const OuterBox& box, double spacing);

[[nodiscard]] bool corner(const OuterBox& box, Vec2 at);

}  // namespace vortree::sph
