#pragma once

#include <array>

#include "base/vec2.hpp"
#include "body/outlines/panel_limits.hpp"
#include "body/settings.hpp"
#include "body/shape.hpp"

// What scenes ask of a body's size and form. All follows from its outline, which each function of
// settings draws anew; no function knows a shape.
//
// cost    0.3 to 0.5 ms each, mostly for drawing

namespace vortree::body {

/// The size D that coefficients and the Reynolds number go by [L]: the shape's own.
[[nodiscard]] double length_of(const BodySettings& body);

/// Length of the outline [L]; that of an ellipse of 50 : 1 to 1e-10.
[[nodiscard]] double perimeter_of(const BodySettings& body);

/// The sharpest end of a body.
///
/// place   as seen from the body's centre: its size is the distance, its direction the way there
/// radius  of the curvature there: R of a circle; b^2/a of an ellipse, b < a; the edge of a foil
struct Tip {
  Vec2 place;
  double radius;
};

/// Of the ends of a body, the places of its outline that are farther from its centre than those
/// beside them, the one where it bends most. The shoulders of a foil's rounded edge bend up to half
/// as much again; they are no ends, and laws of tips are measured by the radius of the edge itself.
/// error   round-off where the tip is among the places of Shape::trace, as those of ellipses and
///         foils by formula are; elsewhere 1e-8 of the size in its place
[[nodiscard]] Tip tip_of(const BodySettings& body);

/// How long panels along it may be.
[[nodiscard]] PanelLimits panel_limits_of(const BodySettings& body);

/// A circle about its centre, of whatever shape: it has no tip, and can turn in its place.
[[nodiscard]] bool round(const BodySettings& body);

/// Half the sides of the rectangle about its centre, along the axes of the scene, that the body
/// just fills, to round-off.
[[nodiscard]] std::array<double, 2> half_extent(const Shape& outline);
[[nodiscard]] std::array<double, 2> half_extent(const BodySettings& body);

/// The distance from its centre of the place of an outline that is farthest, to round-off: the
/// radius of the least circle about the centre that holds it [L].
[[nodiscard]] double farthest_of(const Shape& outline);

/// Whether a point of the scene lies within the body or on its wall.
[[nodiscard]] bool covers(const BodySettings& body, const std::array<double, 2>& point);

}  // namespace vortree::body
