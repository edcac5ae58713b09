#pragma once

#include <vector>

#include "body/shapes/from_points/contour.hpp"

namespace vortree::body {

/// The chord of a contour with a trailing edge: from the place that is farthest from the edge, the
/// nose, to the middle of the edge.
struct Chord {
  Vec2 nose, tail;
  std::size_t farthest;  // the place that is the nose

  [[nodiscard]] double length() const;
};
[[nodiscard]] Chord chord_of(const Contour& contour);

/// The radius that an edge gets, in chords: what was asked for, or half the thickness of a blunt
/// edge, if that is more.
[[nodiscard]] double radius_of_edge(const Contour& contour, double edge);

/// Places of the same section with a rounded trailing edge; the first is the tip. Behind the middle
/// of the chord, x = 1/2, half the thickness y of what a spline through the places is becomes
///
///   (y + o w) (1 + w (sqrt((1 - x)/(1 - x + r/2)) - 1)),   w = (2 x - 1)^4,   o = r - y(1),
///
/// in chords, r the radius of the edge, y(1) half the thickness of a blunt one; the mean line and
/// the chord stay. Places stand as close as r/8 around the edge.
/// throws  BadPoint if one of its sides runs forth and back behind the middle of the chord
[[nodiscard]] std::vector<Vec2> rounded_behind(const Contour& contour, double edge);

}  // namespace vortree::body
