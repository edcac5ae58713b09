#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "body/outlines/outline.hpp"

namespace vortree::body {

/// A part of a closed curve.
///
/// at      by a parameter from 0 to 1
/// length  [L]
/// turns   by how much its direction turns from end to end, either way [rad]
struct Stretch {
  std::function<CurvePoint(double share)> at;
  double length, turns;
};

[[nodiscard]] Stretch line(Vec2 from, Vec2 to);

/// The outline that goes along stretches one after another, each of which ends where and as the
/// next begins. Of the parameter half is shared out by length and half by how much they turn, so
/// that places are closer where it bends. Directions agree where stretches meet; curvature need
/// not, and is then that of one of them.
[[nodiscard]] std::unique_ptr<Shape> chained(const std::vector<Stretch>& stretches,
                                             const Placement& place);

}  // namespace vortree::body
