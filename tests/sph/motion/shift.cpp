#include "sph/motion/shift.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sph/operators/clouds.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

constexpr double round_off = 2.2e-16;

/// A cloud that carries what it is given, and its slopes.
struct Ready {
  Cloud cloud;
  Stencils stencils;
  std::vector<Slopes> slopes;

  explicit Ready(Cloud of, const OperatorOptions& options = {}) : cloud(std::move(of)) {
    stencils.renew(cloud, options);
    find_slopes(cloud, stencils, slopes);
  }
};

void set_velocity(Cloud& cloud, const auto& now, const auto& before) {
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec2 u = now(cloud.at(i)), w = before(cloud.at(i));
    cloud.u[i] = u.x, cloud.v[i] = u.y, cloud.u_before[i] = w.x, cloud.v_before[i] = w.y;
  }
}

double nearest_pair(const Cloud& cloud) {
  double least = 1e9;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Vec2 d = cloud.at(i) - cloud.at(j);
      d.x -= std::round(d.x), d.y -= std::round(d.y);
      least = std::min(least, std::hypot(d.x, d.y));
    }
  return least;
}

}  // namespace

TEST_CASE("in a lattice nobody is pushed, and a uniform stream carries all alike") {
  Cloud lattice_cloud = lattice({0, 0}, {1, 1}, 0.1);
  set_velocity(
      lattice_cloud,
      [](Vec2) {
        return Vec2{2, -1};
      },
      [](Vec2) {
        return Vec2{1, -1};
      });
  Ready ready(lattice_cloud, {2, 2.8, 1});
  const std::vector<Vec2> push = repulsions(ready.cloud, ready.stencils);
  for (std::size_t i = 0; i < ready.cloud.size(); ++i) {
    CHECK(std::hypot(push[i].x, push[i].y) <
          24 * 8 * round_off);  // so many neighbors; places near 1
  }
  const TimeStep step{0.01, 0.5};
  shift_and_move(ready.cloud, ready.stencils, ready.slopes, step, 6);
  for (std::size_t i = 0; i < ready.cloud.size(); ++i) {
    // (1 + w/2) u - w/2 u_before
    CHECK(ready.cloud.x[i] - lattice_cloud.x[i] == Approx(0.01 * (1.25 * 2 - 0.25)).epsilon(1e-11));
    CHECK(ready.cloud.y[i] - lattice_cloud.y[i] == Approx(-0.01).epsilon(1e-11));
    CHECK(ready.cloud.u[i] == Approx(2).epsilon(1e-13));
    CHECK(ready.cloud.u_before[i] == Approx(1).epsilon(1e-13));
  }
  Cloud still = lattice_cloud;
  spread_evenly(still, ready.stencils);
  for (std::size_t i = 0; i < still.size(); ++i)
    CHECK(still.x[i] == Approx(lattice_cloud.x[i]).epsilon(1e-14));
}

TEST_CASE("repulsion is the sum over neighbors nearer than 1.5 spacings, away from them") {
  Cloud cloud = uneven_cloud(9, 71);
  cloud.add(cloud.at(3), cloud.spacing[3], ParticleKind::fluid);  // gives nothing to its twin
  Stencils stencils;
  stencils.renew(cloud, {});
  const std::vector<Vec2> found = repulsions(cloud, stencils);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    Vec2 sum{};
    for (std::size_t j = 0; j < cloud.size(); ++j) {
      const Vec2 d = cloud.at(i) - cloud.at(j);
      const double r = std::hypot(d.x, d.y), s = (cloud.spacing[i] + cloud.spacing[j]) / 2;
      if (r > 0 && r < 1.5 * s) sum += std::pow(1 - r / (1.5 * s), 2) / r * d;
    }
    CHECK(found[i].x == Approx(sum.x).margin(1e-13));
    CHECK(found[i].y == Approx(sum.y).margin(1e-13));
  }
}

TEST_CASE("fluid that nothing stirs stays where it is") {
  Ready ready(uneven_cloud(9, 72));
  const Cloud before = ready.cloud;
  shift_and_move(ready.cloud, ready.stencils, ready.slopes, {0.1, 1}, 6);
  CHECK(ready.cloud.x == before.x);
  CHECK(ready.cloud.y == before.y);
}

TEST_CASE("a shift is at most 0.15 spacings, and carries quadratic fields exactly") {
  const auto shear = [](Vec2 at) { return Vec2{1e-3 * at.y, 0}; };
  Cloud cloud = uneven_cloud(12, 73);
  set_velocity(cloud, shear, shear);
  Chance chance(3);
  const Polynomial p(2, chance);
  cloud.p = values(cloud, p);
  Ready ready(cloud);
  const double dt = 10;  // moves by 1e-2, and the shift by its bound
  shift_and_move(ready.cloud, ready.stencils, ready.slopes, {dt, 1}, 100);
  double most = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    // Who moved from x + shift to x' with the velocity there has come by shift and dt u.
    const Vec2 moved = ready.cloud.at(i) - dt * Vec2{ready.cloud.u[i], ready.cloud.v[i]};
    const Vec2 by = moved - cloud.at(i);
    const double length = std::hypot(by.x, by.y) / cloud.spacing[i];
    most = std::max(most, length);
    CHECK(length < 0.15 * (1 + 1e-10));
    CHECK(ready.cloud.p[i] == Approx(p(moved)).margin(1e-10));
    CHECK(ready.cloud.u[i] == Approx(shear(moved).x).margin(1e-12));
  }
  CHECK(most > 0.14);
}

TEST_CASE("only free particles move; nodes of walls and inflows keep what they carry, too") {
  for (const ParticleKind kind :
       {ParticleKind::ring, ParticleKind::wall, ParticleKind::outer, ParticleKind::outlet}) {
    Cloud cloud = uneven_cloud(8, 74);
    std::ranges::fill(cloud.kind, kind);
    set_velocity(
        cloud,
        [](Vec2 at) {
          return Vec2{at.y, at.x};
        },
        [](Vec2) {
          return Vec2{1, 0};
        });
    Ready ready(cloud);
    shift_and_move(ready.cloud, ready.stencils, ready.slopes, {0.01, 1}, 6);
    spread_evenly(ready.cloud, ready.stencils);
    CHECK(ready.cloud.x == cloud.x);
    CHECK(ready.cloud.y == cloud.y);
    const bool passed = kind == ParticleKind::ring || kind == ParticleKind::outlet;
    CHECK((ready.cloud.u == cloud.u) == !passed);
  }
}

TEST_CASE("rings and outlets take linear fields from where the flow brings them, exactly") {
  const auto shear = [](Vec2 at) { return Vec2{0.5 * at.y, 0}; };  // the same at X as here
  Cloud cloud = uneven_cloud(10, 75);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud.kind[i] = i % 3 ? ParticleKind::ring : ParticleKind::outlet;
  set_velocity(cloud, shear, shear);
  const auto linear = [](Vec2 at) { return 1 + 2 * at.x - 3 * at.y; };
  cloud.p = values(cloud, linear);
  Ready ready(cloud);
  const double dt = 0.05;
  shift_and_move(ready.cloud, ready.stencils, ready.slopes, {dt, 0.7}, 6);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec2 from = cloud.at(i) - dt * shear(cloud.at(i));
    CHECK(ready.cloud.p[i] == Approx(linear(from)).margin(1e-12));
    CHECK(ready.cloud.u[i] == Approx(shear(from).x).margin(1e-12));
  }
}

TEST_CASE("where the flow brings a ring's fluid from is found to second order in dt") {
  // From x fluid came in dt along a circle, at the speed 1 about the middle.
  const auto turning = [](Vec2 at) { return Vec2{-(at.y - 0.5), at.x - 0.5}; };
  const auto error = [&](double dt) {
    Cloud cloud = uneven_cloud(10, 76);
    std::ranges::fill(cloud.kind, ParticleKind::ring);
    set_velocity(cloud, turning, turning);
    cloud.p = values(cloud, [](Vec2 at) { return at.x; });
    Ready ready(cloud);
    shift_and_move(ready.cloud, ready.stencils, ready.slopes, {dt, 1}, 6);
    double worst = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const Vec2 d = cloud.at(i) - Vec2{0.5, 0.5};
      const double exact = 0.5 + d.x * std::cos(dt) + d.y * std::sin(dt);
      worst = std::max(worst, std::abs(ready.cloud.p[i] - exact));
    }
    return worst;
  };
  // -dt u(X) with u at X, the place it came from, errs by dt^2/2; u here would, too, the other way.
  CHECK(std::log2(error(0.02) / error(0.01)) > 1.9);
}

TEST_CASE("spreading drives particles apart") {
  Cloud cloud = uneven_cloud(14, 77, 0.45, false);
  std::ranges::fill(cloud.spacing, 1.0 / 14);
  const double before = nearest_pair(cloud) * 14;
  Stencils stencils;
  for (int k = 0; k < 50; ++k) {
    stencils.renew(cloud, {2, 2.8, 1});
    const Cloud old = cloud;
    spread_evenly(cloud, stencils);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const Vec2 by = cloud.at(i) - old.at(i);
      REQUIRE(std::hypot(by.x, by.y) < 0.1 / 14 * (1 + 1e-12));
    }
    for (double& x : cloud.x) x -= std::floor(x);
    for (double& y : cloud.y) y -= std::floor(y);
  }
  CHECK(before < 0.5);
  CHECK(nearest_pair(cloud) * 14 > 0.75);
}
