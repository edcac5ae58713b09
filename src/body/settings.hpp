#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/keys.hpp"
#include "base/kinds.hpp"
#include "body/course.hpp"

// The tables [body], [plunge] and [motion] of a scene.

namespace vortree::body {

struct ShapeKind;

/// What the first of the shapes is, and the numbers of all, none of them set yet.
[[nodiscard]] const ShapeKind* first_shape();
[[nodiscard]] Dimensions numbers_of_shapes();

/// The body moves without turning: X(t) = amplitude cos(2 pi frequency t) along a direction. All
/// positions and velocities that a run writes are those in the frame of the body
/// (body/motion.hpp); forces are those that it feels.
struct PlungeSettings {
  double amplitude = 0, frequency = 0;
  std::array<double, 2> direction{0, 1};
  bool operator==(const PlungeSettings&) const = default;
};

/// How a body moves, or all of them together: its pivot by x, y [L], and the body about it by
/// `angle` (degrees, anticlockwise), each as an expression of t, or all as columns of a file; or as
/// a circle that turns about its centre at a steady rate, `spin`, from t = 0 on.
///
/// about   the pivot, from the body's centre at angle 0
/// course  what x, y, angle or the file say, once a scene has been read
struct MotionSettings {
  double spin = 0;
  std::optional<std::string> x{}, y{}, angle{}, file{};
  std::array<double, 2> about{0, 0};
  Course course{};
  bool operator==(const MotionSettings&) const = default;

  bool given_by_time() const { return x || y || angle || file; }
};

/// A body of some shape (body/shapes/shapes.hpp) with `panels` wall elements; the scene has none in
/// free space. The numbers are those of its shape, by name, as in "radius"; digits and points are
/// there where a shape takes them. It is turned clockwise by `incidence` degrees about its centre.
///
/// file    where the points come from, as written; who reads scenes reads it, and no shape does
/// points  x, y, x, y, ... of places along the outline
/// motion  of one among several, beside that which all have together
struct BodySettings {
  const ShapeKind* shape = first_shape();
  Dimensions numbers = numbers_of_shapes();
  std::optional<std::string> digits{}, file{};
  std::optional<std::vector<double>> points{};
  double incidence = 0;
  std::array<double, 2> centre{0, 0};
  int panels = 520;
  std::optional<MotionSettings> motion{};
  bool operator==(const BodySettings&) const = default;

  /// One of the numbers, or what the shape has where it is not written.
  /// throws  std::invalid_argument if there is neither
  double number(std::string_view name) const;

  /// The incidence in radians.
  double turn() const;
};

/// throws  Refused if a number is written that the shape does not have, or lacking that it needs;
///         if they make no outline
void refuse(const BodySettings&);

/// What a shape makes of what is written that somebody may not expect, in sentences.
[[nodiscard]] std::vector<std::string> told_of(const BodySettings&);

/// throws  Refused if it says nothing, or one thing twice
void refuse(const MotionSettings&);

/// Their keys, in the order in which they are read and printed.
[[nodiscard]] std::vector<Key> keys(BodySettings&);
[[nodiscard]] std::vector<Key> keys(PlungeSettings&);
[[nodiscard]] std::vector<Key> keys(MotionSettings&);

}  // namespace vortree::body
