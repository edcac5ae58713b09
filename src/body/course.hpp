#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec2.hpp"

namespace vortree::body {

/// How a body moves at one time.
///
/// place, velocity, acceleration  of its centre, from where the scene puts it [L, L/T, L/T^2]
/// angle                          by which its outline is turned about the centre, anticlockwise
/// rate, spin_up                  of the turning of its wall [1/T, 1/T^2]
struct Kinematics {
  Vec2 place{}, velocity{}, acceleration{};
  double angle = 0, rate = 0, spin_up = 0;
};

/// One coordinate of a motion at some times: its value and its first two derivatives.
struct Jets {
  std::vector<double> value, first, second;
  bool operator==(const Jets&) const = default;
};

/// A motion by what is known of it at some times: a polynomial of degree five between two of them,
/// which has value, first and second derivative there.
///
///   centre(t) = P(t) + a - R(angle) a,   a the way from the centre to the pivot P at angle 0
///
/// error   (h/T)^6/300 of a sine with period 2 pi T, known h apart; (h/T)^4/20 of its acceleration
class Course {
 public:
  Course() = default;  ///< stands still

  /// times   ascending, two at least
  /// of      x, y of the pivot's displacement [L], and the angle [radians]
  /// about   the pivot, from the centre [L]
  Course(std::vector<double> times, std::array<Jets, 3> of, Vec2 about);

  bool moves() const { return !times_.empty(); }
  bool turns() const { return turns_; }
  Kinematics at(double t) const;  ///< beyond the times as the last polynomial goes on
  std::span<const double> times() const { return times_; }

  bool operator==(const Course&) const = default;

 private:
  std::vector<double> times_;
  std::array<Jets, 3> of_;
  Vec2 about_{};
  bool turns_ = false;
};

/// Derivatives of a function known at even steps, nine at least: by nine neighbors, in the middle
/// of them or, at the ends, aside.
/// error   (h/T)^8/600 of a sine with period 2 pi T, h the step, and round-off: 1e-16/h^2
[[nodiscard]] Jets known_evenly(std::vector<double> values, double step);

/// The cubic spline through values at some times, ascending, four at least; its third derivative
/// does not jump at the second and the last but one.
[[nodiscard]] Jets spline_through(std::span<const double> times, std::vector<double> values);

}  // namespace vortree::body
