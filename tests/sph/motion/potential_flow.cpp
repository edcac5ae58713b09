#include "sph/motion/potential_flow.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "sph/setup.hpp"

using namespace vortree;
using namespace vortree::sph;

namespace {

SphSetup around_circle(double spacing, double half, double spin = 0) {
  const std::shared_ptr<const body::Shape> shape = body::circle({}, 0.5);
  return {.scales = {},
          .ambient = {.steady = {1, 0}},
          .box = {{-half, -half}, {half, half}},
          .wanted = {shape, spacing, 3, 0.5, 2},
          .confines = {{{-half, -half}, {half, half}},
                       StandingBodies({stand(shape, spacing, {}, spin)}),
                       4},
          .operators = {}};
}

Cloud started(const SphSetup& setup, bool unbounded) {
  Cloud cloud = starting_cloud(setup);
  Stencils stencils;
  stencils.renew(cloud, setup.operators);
  start_potential_flow(cloud, stencils, setup.operators, setup.ambient, setup.bodies(), unbounded);
  return cloud;
}

/// Of the stream along x past a circle.
Vec2 past_circle(Vec2 at) {
  const double r2 = dot(at, at), c = 0.25 / (r2 * r2);
  return {1 - c * (at.x * at.x - at.y * at.y), -2 * c * at.x * at.y};
}

struct StartErrors {
  double wall = 0, inside = 0, outer = 0, through = 0;  // root mean squares
};

StartErrors errors(double spacing, double half) {
  const Cloud cloud = started(around_circle(spacing, half), true);
  StartErrors sum;
  int wall = 0, inside = 0, outer = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec2 d = cloud.velocity(i) - past_circle(cloud.at(i));
    if (cloud.kind[i] == ParticleKind::wall) {
      sum.wall += dot(d, d), ++wall;
      sum.through += std::pow(dot(cloud.velocity(i), cloud.normal(i)), 2);
    } else if (cloud.inside(i)) {
      sum.inside += dot(d, d), ++inside;
    } else {
      sum.outer += dot(d, d), ++outer;
    }
  }
  return {std::sqrt(sum.wall / wall), std::sqrt(sum.inside / inside), std::sqrt(sum.outer / outer),
          std::sqrt(sum.through / wall)};
}

}  // namespace

TEST_CASE("the start past a circle is the potential flow, to second order, in a box of any size") {
  const StartErrors coarse = errors(0.1, 2), fine = errors(0.05, 2), wide = errors(0.1, 3);
  CHECK(fine.wall < 0.025);
  CHECK(fine.through < 0.025);
  CHECK(std::log2(coarse.wall / fine.wall) > 1.8);
  CHECK(fine.inside < 0.004);
  CHECK(std::log2(coarse.inside / fine.inside) > 1.3);    // the coarsest, two levels up, decide
  CHECK(wide.wall == Approx(coarse.wall).epsilon(0.02));  // nothing that the box is to blame for
  CHECK(coarse.outer < 0.01);
}

TEST_CASE(
    "in a box that the stream fills, the start is faster beside the body than in free fluid") {
  const SphSetup setup = around_circle(0.1, 1.7);
  const Cloud box = started(setup, false), free = started(setup, true);
  double fastest_box = 0, fastest_free = 0;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (box.kind[i] != ParticleKind::wall) continue;
    fastest_box = std::max(fastest_box, box.u[i]), fastest_free = std::max(fastest_free, free.u[i]);
  }
  // A circle in a channel of 3.4 diameters has the image of its dipole across each wall:
  // 1 + pi^2/3 (D/2/H)^2 to first order.
  const double blockage = 1 + std::pow(std::numbers::pi, 2) / 3 * std::pow(0.5 / 3.4, 2);
  CHECK(fastest_box / fastest_free == Approx(blockage).margin(0.02));
}

TEST_CASE("a circle that turns in a stream starts as one at rest: its wall moves along itself") {
  const SphSetup rest = around_circle(0.1, 2), turning = around_circle(0.1, 2, 3);
  const Cloud a = started(rest, true), b = started(turning, true);
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(b.u[i] == Approx(a.u[i]).margin(1e-6));  // ten times what is left of the system
    CHECK(b.v[i] == Approx(a.v[i]).margin(1e-6));
  }
}
