#pragma once

#include "body/outlines/chain.hpp"

namespace vortree::body {

/// A corner that is rounded smoothly: along the arc length s from its middle the curvature is
///
///   cos^2(pi s/(2 l))/radius,   -l <= s <= l,   l = turns radius,
///
/// which begins and ends as a straight line does, so that curvature and its slope are continuous
/// where it meets lines. (Arcs of circles would jump there, for which the sheet of a stream past a
/// plate with such ends errs by 2 % with panels of 0.7 radii; with these by 2e-5.)
///
/// radius  the least, in the middle
/// turns   from one line to the other, to the left [rad]
struct Bend {
  double radius, turns;

  double length() const { return 2 * turns * radius; }

  /// From the middle to the end: x inward, y along the direction in the middle.
  [[nodiscard]] Vec2 end() const;

  /// From the middle to where the lines that it joins would meet: outward.
  [[nodiscard]] double cut() const;

  /// A stretch of it, from shares -1 .. 1 of l; the middle stands at a place and faces an angle.
  [[nodiscard]] Stretch stretch(Vec2 middle, double faces, double from, double to) const;
};

}  // namespace vortree::body
