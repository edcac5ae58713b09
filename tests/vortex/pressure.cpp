#include "vortex/pressure.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "exact/lamb_oseen.hpp"
#include "exact/spinning_cylinder.hpp"
#include "vortex/blobs/lattice.hpp"
#include "vortex/coarse_flow.hpp"
#include "vortex/cores/halves.hpp"
#include "vortex/flows.hpp"
#include "vortex/solver.hpp"

using namespace vortree;
using vortex::Blobs;
using vortex::Problem;
using vortex::Setup;
using vortex::VortexSolver;

namespace {

const double pi = std::numbers::pi;

struct Places {
  std::vector<double> x, y;

  void add(Vec2 at) { x.push_back(at.x), y.push_back(at.y); }
  tree::Points points() const { return {x, y}; }
  std::size_t size() const { return x.size(); }
};

Problem free_flow(Vec2 stream) {
  return {.flow = {stream, 1e-3},
          .dt = 0.02,
          .advecting_cores = std::numbers::sqrt2,
          .sigma_0 = 0.05,
          .splitting = {},
          .merging = {},
          .sums = {.tolerance = 1e-9, .cores = fmm::Cores::mean}};
}

/// int from r on of u^2/r of a swirl that is bare beyond.
double drop(const auto& swirl, double r, double bare_from, double circulation) {
  double sum = std::pow(circulation / (2 * pi * bare_from), 2) / 2;
  constexpr int n = 4000;
  const double h = (bare_from - r) / n;
  for (int k = 0; k < n; ++k) {
    const double at = r + (k + 0.5) * h;
    sum += std::pow(swirl(at), 2) / at * h;
  }
  return sum;
}

void go(VortexSolver& solver, int steps) {
  while (solver.steps() < steps) solver.step([](std::string_view) {});
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// A way from a to b, cut into an even number of pieces.
struct Way {
  static constexpr int pieces = 40;
  Vec2 a, b;
  Places at;

  Way(Vec2 from, Vec2 to) : a(from), b(to) {
    for (int k = 0; k <= pieces; ++k) at.add(a + (static_cast<double>(k) / pieces) * (b - a));
  }
  /// int f ds by Simpson's rule.
  double integral(const auto& f) const {
    double sum = 0;
    for (int k = 0; k <= pieces; ++k) sum += (k == 0 || k == pieces ? 1 : k % 2 ? 4 : 2) * f(k);
    return std::sqrt(dot(b - a, b - a)) / (3 * pieces) * sum;
  }
};

/// How the pressure changes along a way, as told, less what the momentum equation makes of it,
///
///   -int (du/dt - u x omega + nu curl omega + X'') ds - [|u|^2/2],
///
/// du/dt by the steps before and after.
double off_momentum(Setup setup, int steps, const Way& way) {
  const double nu = setup.problem.flow.nu, dt = setup.problem.dt;
  const body::Motion motion = setup.problem.flow.motion;
  const Vec2 d = way.b - way.a, e = unit(d), aside = 0.01 * left_of(e);
  const Way left(way.a + aside, way.b + aside), right(way.a - aside, way.b - aside);
  VortexSolver solver(std::move(setup));
  go(solver, steps - 1);
  const flow::Samples before = solver.sample(way.at.points());
  go(solver, steps);
  const double time = solver.time();
  const flow::Samples now = solver.sample(way.at.points()),
                      to_left = solver.sample(left.at.points()),
                      to_right = solver.sample(right.at.points());
  const std::vector<double> p = solver.pressure(way.at.points());
  go(solver, steps + 1);
  const flow::Samples after = solver.sample(way.at.points());
  const auto along = [&](const flow::Samples& s, int k) { return s.u[k] * e.x + s.v[k] * e.y; };
  const double by_momentum = way.integral([&](int k) {
    return -(along(after, k) - along(before, k)) / (2 * dt) +
           now.omega[k] * (now.v[k] * e.x - now.u[k] * e.y) -
           nu * (to_left.omega[k] - to_right.omega[k]) / 0.02;
  });
  const auto speed = [&](int k) { return (now.u[k] * now.u[k] + now.v[k] * now.v[k]) / 2; };
  const double frame = dot(motion.at(time).acceleration, d);
  return p[Way::pieces] - p[0] - by_momentum - speed(0) + speed(Way::pieces) + frame;
}

/// The ellipse that pitches about a point aside of its centre and goes on with a changing speed.
Setup pitching() {
  std::vector<double> times, zeros(201), x, angle;
  for (int i = 0; i <= 200; ++i) {
    const double t = 0.01 * i;
    times.push_back(t);
    x.push_back(0.1 * std::sin(2 * t) - 0.2 * t);
    angle.push_back(0.5 * std::sin(1.5 * t));
  }
  const body::Jets still = body::known_evenly(zeros, 0.01);
  const body::Course course(
      times, {body::known_evenly(x, 0.01), still, body::known_evenly(angle, 0.01)}, {0.1, 0});
  return test::coarse_flow(body::ellipse({0.05, 0.02}, 0.5, 0.3, 0.2), {.course = course}, {1, 0},
                           0.01, 0.02);
}

/// Past a circle of diameter 1 at Re = 100.
Setup circle(double dt, int panels, const body::Motion& motion = {}) {
  return test::coarse_flow(body::circle({}, 0.5), motion, {1, 0}, 0.01, dt, panels);
}

}  // namespace

TEST_CASE("the pressure of a vortex is what turns the fluid, to fourth order in the cores") {
  const exact::LambOseen oseen{1, 0.2, 1e-3};
  const auto swirl = [&](double r) { return oseen.swirl(r, 0); };
  const double least = -drop(swirl, 0, 1.5, 1);
  const auto off = [&](double core) {
    const Blobs blobs = vortex::gaussian_vortex({}, 1, 0.2, core, 0.9 * core);
    double largest = 0;
    for (const double r : {0.0, 0.1, 0.2, 0.3, 0.5, 1.0}) {
      Places at;
      at.add({r * std::cos(7 * r), r * std::sin(7 * r)});
      const double p = vortex::pressure_at(at.points(), blobs, free_flow({0.4, -0.3}))[0];
      largest = std::max(largest, std::abs(p + drop(swirl, r, 1.5, 1)));
    }
    return largest;
  };
  const double coarse = off(0.05), fine = off(0.025);
  CHECK(coarse < -8e-3 * least);
  CHECK(fine < coarse / 12);  // 16 in the limit
}

TEST_CASE("vortices far from each other have the pressure of potential flow that changes in time") {
  // Of each phi = gamma theta/(2 pi), which it takes along: p = sum_j U_j u_j - |sum_j u_j|^2/2.
  const Vec2 centres[] = {{-1, 0.2}, {1.1, -0.3}, {0.2, 1.4}};
  const double gammas[] = {1, -0.7, 0.4};
  const auto bare = [&](int j, Vec2 at) {
    const Vec2 d = at - centres[j];
    return gammas[j] / (2 * pi * dot(d, d)) * left_of(d);
  };
  Blobs blobs;
  for (int j = 0; j < 3; ++j) blobs.append(centres[j], gammas[j], 1e-3);
  for (const Vec2 at : {Vec2{0, 0}, Vec2{0.7, 0.9}, Vec2{-1.2, 0.3}, Vec2{5, -3}}) {
    double p = 0;
    Vec2 whole;
    for (int j = 0; j < 3; ++j) {
      Vec2 carried;
      for (int k = 0; k < 3; ++k)
        if (k != j) carried += bare(k, centres[j]);
      p += dot(carried, bare(j, at));
      whole += bare(j, at);
    }
    p -= dot(whole, whole) / 2;
    Places places;
    places.add(at);
    // gamma^2 core^2 is all that cores do to it.
    CHECK(vortex::pressure_at(places.points(), blobs, free_flow({2, 1}))[0] ==
          Approx(p).margin(3e-6));
  }
}

TEST_CASE("strained cores have the pressure of the halves they act as") {
  Blobs strained = test::cloud(40, 0.05, 0.1);
  for (std::size_t i = 0; i < strained.size(); ++i)
    strained.xx[i] = 0.3 * strained.sigma[i] * strained.sigma[i],
    strained.xy[i] = i % 2 ? 0.1 * strained.xx[i] : -strained.xx[i];
  const Blobs halves = vortex::Halves(strained).parts;
  REQUIRE(halves.size() == 80);
  Places at;
  for (int k = 0; k < 30; ++k) at.add({0.03 * k - 0.45, 0.4 * std::sin(k)});
  const Problem p = free_flow({});
  const auto a = vortex::pressure_at(at.points(), strained, p),
             b = vortex::pressure_at(at.points(), halves, p);
  for (std::size_t k = 0; k < a.size(); ++k) CHECK(a[k] == Approx(b[k]).epsilon(1e-6));
}

TEST_CASE("the field goes over into the pressure along the wall") {
  // The two know its level by different sums. Where the wall moves, the slip that is left of its
  // speed enters |u|^2.
  const auto off = [](Setup setup, int steps) {
    const auto standing = setup.wall->at(0);
    const vortex::Wall& wall = standing->wall;
    const double dt = setup.problem.dt;
    const body::Motion motion = setup.problem.flow.motion;
    const Turn turn(motion.at(steps * dt).angle);
    Places at;
    for (const Vec2 middle : wall.middles())
      at.add(turn(middle + 1e-4 * wall.shape().nearest(middle).normal));
    VortexSolver solver(std::move(setup));
    go(solver, steps);
    const std::vector<double> rows = solver.frame_rows(), p = solver.pressure(at.points());
    double largest = 0;
    for (std::size_t k = 0; k < p.size(); ++k)
      largest = std::max(largest, std::abs(p[k] - rows[7 * k + 5] / 2));
    return largest;
  };
  // A panel beside which blobs have merged in the last step is 0.01 off.
  CHECK(off(circle(0.02, 160), 40) < 0.01);
  CHECK(off(circle(0.01, 220), 80) < 0.01);
  const body::Motion plunge{.plunge = {{0.05, 0.1}, 0.8}};
  const double plunging = off(circle(0.02, 160, plunge), 40);
  CHECK(plunging < 0.025);
  CHECK(off(circle(0.01, 220, plunge), 80) < 0.8 * plunging);
  CHECK(off(circle(0.02, 160, {.spin = {2}}), 40) < 0.025);
  CHECK(off(pitching(), 40) < 0.025);
}

TEST_CASE("around a circle that spins pressure falls by what turns the fluid") {
  const double rate = 2, R = 0.5, nu = 0.01;
  const exact::SpinningCylinder exact{rate, R, nu};
  const auto swirl = [&](double r) { return exact.swirl(r, 0.5); };
  const auto off = [&](double dt, int panels) {
    Setup setup = test::coarse_flow(body::circle({}, R), {.spin = {rate}}, {}, nu, dt, panels);
    VortexSolver solver(std::move(setup));
    go(solver, static_cast<int>(std::lround(0.5 / dt)));
    double largest = 0;
    for (const double r : {R + 0.01, R + 0.05, R + 0.1, R + 0.3}) {
      Places at;
      for (int k = 0; k < 40; ++k) at.add({r * std::cos(k * pi / 20), r * std::sin(k * pi / 20)});
      const double p = mean(solver.pressure(at.points()));
      largest = std::max(largest, std::abs(p + drop(swirl, r, R + 1, 0)));
    }
    return largest;
  };
  const double coarse = off(0.02, 160), fine = off(0.01, 220);
  CHECK(coarse < 0.006);
  CHECK(fine < 0.6 * coarse);  // as the square of the cores
}

TEST_CASE("pressure changes from place to place as momentum asks, however the body moves") {
  // Steps err by merging and splitting: du/dt by some 0.01 U^2 along a way of these lengths where
  // there is vorticity, less elsewhere. Any term left out would be seen: unsteady, frame and
  // vorticity are 0.1 to 1 U^2 each.
  const Way ahead({-1, 0.1}, {-0.6, 0.3}), aside({0, 0.51}, {0, 0.9}),
      behind({0.6, -0.3}, {1.2, 0.3});
  const body::Motion plunge{.plunge = {{0.05, 0.1}, 0.8}}, spin{.spin = {2}};
  const auto check = [&](auto setup) {
    CHECK(std::abs(off_momentum(setup(), 50, ahead)) < 0.006);
    CHECK(std::abs(off_momentum(setup(), 50, aside)) < 0.03);
    CHECK(std::abs(off_momentum(setup(), 50, behind)) < 0.03);
  };
  check([] { return circle(0.02, 160); });
  check([&] { return circle(0.02, 160, plunge); });
  check([&] { return circle(0.02, 160, spin); });
  check(pitching);
}

TEST_CASE("far away pressure is that of the force on the fluid") {
  // p -> F x/(2 pi r^2), F = -drag; of next order is a quadrupole.
  VortexSolver solver(circle(0.02, 160));
  flow::ForceHistory history({.body = true, .impulsive = true});
  history.add(*solver.force());
  for (int k = 0; k < 60; ++k) {
    solver.step([](std::string_view) {});
    history.add(*solver.force());
  }
  const double drag = flow::measured(history.of_last(), "cd_impulse") / 2, r = 200;
  Places at;
  at.add({-r, 0}), at.add({r, 0}), at.add({0, r});
  const std::vector<double> p = solver.pressure(at.points());
  CHECK(pi * r * (p[0] - p[1]) == Approx(drag).epsilon(0.003));
  CHECK(std::abs(2 * pi * r * p[2]) < 0.03 * drag);
}

TEST_CASE("there is no pressure within a body, nor of an impulsive start") {
  VortexSolver solver(circle(0.02, 160));
  Places at;
  at.add({0, 0}), at.add({0.3, -0.2}), at.add({0.6, 0});
  CHECK(solver.pressure(at.points()).empty());
  go(solver, 1);
  const std::vector<double> p = solver.pressure(at.points());
  CHECK(p[0] == 0);
  CHECK(p[1] == 0);
  CHECK(p[2] != 0);
  Setup setup = circle(0.02, 160);
  setup.problem.moving = setup.wall.get();
  stand(setup.problem, 0);
  CHECK_THROWS_WITH(vortex::pressure_at(at.points(), {}, setup.problem),
                    "0 values along a wall of 160 panels");
}
