#pragma once

#include <span>
#include <vector>

#include "body/shape.hpp"
#include "tree/order/points.hpp"

namespace vortree::flow {

/// Where the closed wake behind a body is looked for: points downstream of the body's centre, from
/// the wall on, 3 % of their distance from it apart.
///
/// length  from the wall [m]; direction of the stream, a unit vector
struct WakeLine {
  std::vector<double> length, x, y;
  Vec2 direction;

  tree::Points points() const { return {x, y}; }
};

/// wall    places all around the outline, evenly
/// stream  must not be 0
WakeLine wake_line(std::span<const Vec2> wall, const body::Shape& shape, Vec2 stream);

/// Length of the closed wake: from the wall to the place where the velocity along the stream turns
/// from back to forward, between the points linear; 0 while there is none [m].
///
/// u, v  velocities at the points of the line, stream and all
double bubble_length(const WakeLine& line, std::span<const double> u, std::span<const double> v);

/// Angle of the main separation from the rear of the body, seen from its centre, mean of both
/// sides; 0 while the flow is attached [degrees].
///
/// Walking from the front along the wall, the place where the wall vorticity first changes its sign
/// for three places or more, between the places linear. It is to be smooth.
double separation_angle(std::span<const double> wall_vorticity, std::span<const Vec2> wall,
                        Vec2 stream);

}  // namespace vortree::flow
