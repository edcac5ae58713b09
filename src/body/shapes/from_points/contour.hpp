#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/vec2.hpp"

namespace vortree::body {

/// Points that make no outline, in words for the user.
///
/// point  the number of the first of them that is to blame, from 0
struct BadPoint : std::runtime_error {
  BadPoint(std::size_t number, const std::string& words)
      : std::runtime_error(words), point(number) {}
  std::size_t point;
};

/// Whether an outline has a trailing edge, where its first point stands: a corner of more than 80
/// degrees; or, blunt, a side that leads from the last point to the first, with a corner of more
/// than 45 degrees at each of them.
enum class Edge { none, sharp, blunt };

/// Points along a closed curve, as it is drawn through them.
///
/// places     anticlockwise, none twice; from the edge on, if there is one. A blunt edge has two
///            ends, the first and the last place
/// clockwise  they were written the other way round
struct Contour {
  std::vector<Vec2> places;
  bool clockwise = false;
  Edge edge = Edge::none;

  /// From end to end of a blunt edge; 0 of a sharp one.
  [[nodiscard]] double gap() const;
};

/// coordinates  x, y, x, y, ...; the first point may be there again as the last
/// throws       BadPoint for what `hold_points` names but for crossings
[[nodiscard]] Contour contour_of(std::span<const double> coordinates);

/// throws  BadPoint unless points make an outline: eight of them at least and a thousand at most,
///         all finite, none the same as the one before; no corner of more than 80 degrees but at
///         the first, which is the trailing edge; closed, but for a side that is no longer than
///         four times the longer of those beside it, or a blunt edge of a tenth of the length; no
///         two sides that cross
void hold_points(std::span<const double> coordinates);

}  // namespace vortree::body
