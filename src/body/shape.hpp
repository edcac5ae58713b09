#pragma once

#include <cstddef>
#include <vector>

#include "base/vec2.hpp"

namespace vortree::body {

/// The place on a wall that is nearest to a point of the plane.
///
/// arc        arc length from the curve's first point, anticlockwise [m]
/// distance   to the wall [m]; negative inside the body
/// normal     unit, outward; the tangent (-normal.y, normal.x) runs anticlockwise
/// curvature  1/m; positive where the body is convex
struct WallPoint {
  double arc, distance;
  Vec2 normal;
  double curvature;

  Vec2 tangent() const { return {-normal.y, normal.x}; }
};

/// A place on an outline, how it bends there and its arc length, as in WallPoint.
struct OutlinePoint {
  Vec2 at;
  double curvature, arc;
};

/// A closed curve without double points, or several apart from each other
/// (body/outlines/shape_group.hpp): all that the wall knows of bodies.
class Shape {
 public:
  virtual ~Shape() = default;
  virtual double perimeter() const = 0;
  /// Of each of the curves, whose arcs run on from one to the next
  virtual std::vector<double> perimeters() const { return {perimeter()}; }
  /// The number of the curve that has an arc
  virtual std::size_t curve_at(double /*arc*/) const { return 0; }
  virtual Vec2 point(double arc) const = 0;
  virtual WallPoint nearest(Vec2 at) const = 0;
  /// nearest(at).distance, to round-off, for those who need no more
  virtual double distance(Vec2 at) const { return nearest(at).distance; }
  /// True only outside the body and farther than d from the wall; false there, too, if that would
  /// take more than a few operations to find out. Most blobs of a wake need nothing else.
  virtual bool beyond(Vec2 /*at*/, double /*d*/) const { return false; }
  /// 512 places one after another from the first point on, at even steps of the arc, or of a
  /// parameter that has them closer where the curve bends
  virtual std::vector<OutlinePoint> trace() const;
};

}  // namespace vortree::body
