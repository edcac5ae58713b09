#pragma once

#include <span>
#include <vector>

#include "body/outlines/piece.hpp"

namespace vortree::body {

/// A curve through points: cubics by the sum of the chords, with continuous second derivative, so
/// that its curvature is continuous, too.
///
/// By the sum of the chords, and not of their roots (centripetal), because the speed is then 1 to
/// the square of the spacing even where points stand unevenly; with any other the order is lost
/// there (Floater, Numer. Math. 109 (2008)).
/// error   of fourth order in the spacing, for a curve that is smooth
/// throws  std::invalid_argument of less than four points
class Spline {
 public:
  /// From the first point to the last; at both ends with the slope of the cubic through four.
  [[nodiscard]] static Spline open(std::span<const Vec2> points);
  /// Around, from the first point to itself.
  [[nodiscard]] static Spline closed(std::span<const Vec2> points);

  [[nodiscard]] std::size_t stretches() const { return knot_.size() - 1; }
  /// Sum of the chords up to a point.
  [[nodiscard]] double knot(std::size_t point) const { return knot_[point]; }
  /// On the stretch behind a point, by the sum of the chords.
  [[nodiscard]] CurvePoint at(std::size_t stretch, double chords) const;

 private:
  explicit Spline(std::span<const Vec2> points);
  void solve_open();
  void solve_closed();

  std::vector<double> knot_;
  std::vector<Vec2> point_, bend_;  // bend: second derivative at the points
};

}  // namespace vortree::body
