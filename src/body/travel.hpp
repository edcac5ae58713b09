#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "body/bodies.hpp"

// What bodies do on their way, from t = 0 to the end of a run.

namespace vortree::body {

/// The greatest of a course at the times by which it is known, of its centre and of its turning
/// [L/T, L/T^2, 1/T, 1/T^2].
struct FastestMoves {
  double speed = 0, acceleration = 0, rate = 0, spin_up = 0;

  explicit FastestMoves(const Course& course);

  /// Of the cosines that have the same; infinity where velocity and rate are steady.
  double period() const;
};

/// The fastest that the centre of any body goes by its motions, as a vector [L/T]: at the times by
/// which its courses are known, and in a plunge at 1000 even ones.
[[nodiscard]] Vec2 fastest_velocity(const Bodies& bodies, double end);

/// Where two of several bodies, first < second, are nearest to each other: how far apart, negative
/// where they overlap, and when.
struct NearestApproach {
  std::size_t first, second;
  double gap, time;
  bool operator==(const NearestApproach&) const = default;
};

/// Of all pairs; of those that move against each other the nearest of 1000 even times.
/// cost  0.3 ms for each time at which a pair is nearer than before
[[nodiscard]] std::vector<NearestApproach> meetings(const Bodies& bodies, double end);

/// The rectangle [x0, y0, x1, y1] that a body fills in the frame of all, wherever it goes. One that
/// turns by its course is taken for a circle.
[[nodiscard]] std::array<double, 4> place_of(const Body& body, double end);

}  // namespace vortree::body
