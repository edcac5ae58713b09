#include "body/travel.hpp"

#include <catch2/catch.hpp>
#include <memory>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"

using namespace vortree;
using body::Bodies;
using body::Body;

namespace {

/// A straight way at a steady velocity, turning at a steady rate, until t = 4.
body::Motion steady(Vec2 velocity, double rate = 0) {
  const std::vector<double> t{0, 4};
  const auto along = [&](double speed) {
    return body::Jets{{0, 4 * speed}, {speed, speed}, {0, 0}};
  };
  body::Motion motion;
  motion.course = {t, {along(velocity.x), along(velocity.y), along(rate)}, {}};
  return motion;
}

Body circle_at(Vec2 centre, Vec2 velocity) {
  return {body::circle({}, 0.5), centre, {}, steady(velocity), 64};
}

}  // namespace

TEST_CASE("circles that pass each other meet where their centres are nearest, by less both radii") {
  // Centres are (-2 + t, 0.7) and (2 - t, -0.7): nearest at t = 2, 1.4 apart.
  const Bodies bodies{circle_at({-2, 0.7}, {1, 0}), circle_at({2, -0.7}, {-1, 0})};
  const auto found = body::meetings(bodies, 4);
  REQUIRE(found.size() == 1);
  CHECK(found[0].first == 0);
  CHECK(found[0].second == 1);
  CHECK(found[0].time == Approx(2).margin(0.004));  // one of 1000 even times
  CHECK(found[0].gap == Approx(0.4).margin(1e-10));
  CHECK(body::meetings({bodies[0]}, 4).empty());
}

TEST_CASE("a body's place holds it wherever it goes, and one that turns whichever way it points") {
  const std::shared_ptr<const body::Shape> ellipse = body::ellipse({}, 1, 0.25, 0);
  const auto straight = body::place_of({ellipse, {1, 2}, {}, steady({1, -0.5}), 64}, 4);
  const auto turning = body::place_of({ellipse, {1, 2}, {}, steady({1, 0}, 0.1), 64}, 4);
  const std::array<double, 4> held{0, -0.25, 6, 2.25}, round{0, 1, 6, 3};
  for (int side = 0; side < 4; ++side) {
    CHECK(straight[side] == Approx(held[side]).margin(1e-12));
    CHECK(turning[side] == Approx(round[side]).margin(1e-12));
  }
}

TEST_CASE("velocities of all bodies together and of each on its own add up in the fastest") {
  Bodies bodies{circle_at({0, 0}, {1, 0}), circle_at({3, 0}, {-2, 0})};
  for (Body& one : bodies) one.motion = steady({0.5, 0});
  CHECK(body::fastest_velocity(bodies, 4).x == Approx(1.5));  // 0.5 + 1; the other has 0.5 - 2
  bodies[1].own = steady({-2.2, 0});
  CHECK(body::fastest_velocity(bodies, 4).x == Approx(-1.7));
}
