#pragma once

#include "vortex/blobs.hpp"

namespace vortree::vortex {

/// A part of the plane, sides parallel to the axes.
struct Box {
  Vec2 low, high;

  bool holds(Vec2 at) const {
    return at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y;
  }
};

/// Replaces all blobs outside the box by one of each sign, at their centre of circulation and as
/// wide as the widest of them: what has left, and what left before, goes on as two vortices.
///
/// Circulation and impulse are conserved exactly, so that forces and Kelvin's theorem notice
/// nothing; the rest of the field inside changes by O(extent^2/distance^2) of what the outside
/// adds, a small part of it where both signs leave in turn.
void retire(Blobs& blobs, const Box& box);

}  // namespace vortree::vortex
