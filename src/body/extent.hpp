#pragma once

#include "body/settings.hpp"

namespace vortree::body {

/// The size of a body that coefficients and the Reynolds number go by: twice its radius, or its
/// chord.
[[nodiscard]] double length_of(const BodySettings&);

/// Its perimeter, to 1 % (an ellipse's: 4e-4).
[[nodiscard]] double perimeter_of(const BodySettings&);

/// The radius of NACA 0012's trailing edge, as a share of the chord.
[[nodiscard]] double edge_of(const BodySettings&);

/// The smallest radius of a body's curvature: across^2/radius at the tips of an ellipse, the
/// trailing edge of a foil.
[[nodiscard]] double tip_radius(const BodySettings&);

/// Half the sides of the rectangle, along the axes, that a body just fills, or a little more.
[[nodiscard]] Pair half_extent(const BodySettings&);

/// Whether a point lies within a body; for a foil, in the thick of it.
[[nodiscard]] bool covers(const BodySettings&, const Pair& point);

}  // namespace vortree::body
