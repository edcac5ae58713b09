#include "vortex/near_wake.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace vortree;
using vortex::Vec2;

namespace {

/// The velocity a (s - length) along a line's direction, s the distance from the wall.
double bubble_of_straight_line(double a, double length) {
  const vortex::Wall wall(vortex::circle({0.3, -0.2}, 0.5), 200);
  const vortex::WakeLine line = vortex::wake_line(wall, {3, 4});
  vortex::Velocities u(line.x.size());
  for (std::size_t k = 0; k < line.x.size(); ++k) {
    const double s = std::hypot(line.x[k] - 0.3, line.y[k] + 0.2) - 0.5;
    u.u[k] = 0.6 * a * (s - length) - 0.8;  // and something across
    u.v[k] = 0.8 * a * (s - length) + 0.6;
  }
  return vortex::bubble_length(line, u);
}

}  // namespace

TEST_CASE("the closed wake ends where the velocity along the stream turns forward") {
  for (double length : {0.01, 0.37, 5.0})
    CHECK(bubble_of_straight_line(2, length) == Approx(length).epsilon(1e-9));
}

TEST_CASE("without a turn from back to forward no wake is closed") {
  CHECK(bubble_of_straight_line(2, -0.1) == 0);
  CHECK(bubble_of_straight_line(-2, 0.5) == 0);
  CHECK(vortex::bubble_length({}, vortex::Velocities{}) == 0);
}
