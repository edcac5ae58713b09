#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "base/keys.hpp"

// The tables [body], [plunge] and [motion] of a scene.

namespace vortree::body {

/// The outlines that a scene can name.
enum class ShapeKind { circle, ellipse, naca0012 };

}  // namespace vortree::body

namespace vortree {

template <>
inline constexpr std::array<std::string_view, 3> words_of<body::ShapeKind>{"circle", "ellipse",
                                                                           "naca0012"};

}  // namespace vortree

namespace vortree::body {

/// A body with `panels` wall elements; the scene has none in free space. An ellipse has the half
/// axes radius and across; NACA 0012 a chord, about whose middle it is centred, and a trailing edge
/// rounded with the radius edge times chord (0.005 if not written; body/outline.hpp). Long axis
/// and chord are turned clockwise by `incidence` degrees from x. Twice the radius, or the chord, is
/// the length that coefficients and the Reynolds number go by.
struct BodySettings {
  ShapeKind shape = ShapeKind::circle;
  std::optional<double> radius{}, across{}, chord{}, edge{};
  double incidence = 0;
  std::array<double, 2> centre{0, 0};
  int panels = 520;
  bool operator==(const BodySettings&) const = default;
};

/// The body moves without turning: X(t) = amplitude cos(2 pi frequency t) along a direction. All
/// positions and velocities that a run writes are those in the frame of the body
/// (body/motion.hpp); forces are those that it feels.
struct PlungeSettings {
  double amplitude = 0, frequency = 0;
  std::array<double, 2> direction{0, 1};
  bool operator==(const PlungeSettings&) const = default;
};

/// A circle that turns about its centre at a steady rate, anticlockwise, from t = 0 on.
struct MotionSettings {
  double spin = 0;
  bool operator==(const MotionSettings&) const = default;
};

/// Their keys, in the order in which they are read and printed.
[[nodiscard]] std::vector<Key> keys(BodySettings&);
[[nodiscard]] std::vector<Key> keys(PlungeSettings&);
[[nodiscard]] std::vector<Key> keys(MotionSettings&);

}  // namespace vortree::body
