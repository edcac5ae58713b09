#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "vortex/coarse_flow.hpp"
#include "vortex/motions.hpp"

using namespace vortree;
using test::course;
using test::still;

namespace {

constexpr double far = 60;

const auto silent = [](std::string_view) {};

std::shared_ptr<const body::Shape> ellipse() {
  return body::ellipse({}, 0.5, 0.25, 0);
}

/// That ellipse, in the origin, which moves so; far from it a circle at rest, before it or after it
/// in the list.
vortex::Setup beside_circle(const body::Course& moves, Vec2 stream, bool first) {
  const vortex::WallBody one{ellipse(), 160}, other{body::circle({}, 0.5), 128};
  std::vector<vortex::WallBody> bodies{one, other};
  std::vector<body::Motion> own{{.course = moves}, {}};
  if (!first) std::swap(bodies[0], bodies[1]), std::swap(own[0], own[1]);
  bodies[1].centre = {0, first ? far : -far};
  return test::coarse_flow(std::move(bodies), std::move(own), {}, stream, 0.01, 0.02);
}

/// The same one alone, in its own frame and axes.
vortex::Setup alone(const body::Course& moves, Vec2 stream) {
  return test::coarse_flow(body::ellipse({}, 0.5, 0.25, 0), {.course = moves}, stream, 0.01, 0.02);
}

/// What one body of a run feels at the wall, C_D, C_L and C_M, after each step but the last.
std::vector<std::array<double, 3>> felt(vortex::Setup setup, int steps, std::size_t number) {
  flow::ForceHistory history(setup.scales);
  vortex::VortexSolver solver(std::move(setup));
  const auto force = [&] {
    const auto each = solver.forces_on_each();
    return each.empty() ? *solver.force() : each[number];
  };
  history.add(force());
  std::vector<std::array<double, 3>> rows;
  for (int k = 0; k < steps; ++k) {
    solver.step(silent);
    history.add(force());
    if (history.size() < 3) continue;
    const flow::Measures now = history.of_last_but_one();
    rows.push_back({flow::measured(now, "cd_wall"), flow::measured(now, "cl_wall"),
                    flow::measured(now, "cm_wall")});
  }
  return rows;
}

/// The largest difference from the fourth step on, of each; an impulsive start has its own, of what
/// a step is.
std::array<double, 3> off(const std::vector<std::array<double, 3>>& a,
                          const std::vector<std::array<double, 3>>& b) {
  REQUIRE(a.size() == b.size());
  std::array<double, 3> most{};
  for (std::size_t i = 3; i < a.size(); ++i)
    for (int k : {0, 1, 2}) most[k] = std::max(most[k], std::abs(a[i][k] - b[i][k]));
  return most;
}

}  // namespace

TEST_CASE("a body that moves against another far away feels what it feels in its own frame") {
  const body::Course moves =
      course([](double t) { return -t; }, [](double t) { return 0.1 * std::sin(3 * t); }, still);
  const auto own = felt(alone(moves, {}), 20, 0);
  for (const bool first : {true, false}) {
    const auto there = felt(beside_circle(moves, {}, first), 20, first ? 0 : 1);
    // The other's potential is (D/60)^2 = 3e-4; which blobs merge differs.
    const auto [cd, cl, cm] = off(own, there);
    CHECK(cd < 2e-3);
    CHECK(cl < 3e-3);
    CHECK(cm < 2e-3);
  }
}

TEST_CASE("a body that turns among others feels what it feels in axes that turn with it") {
  const body::Course moves =
      course(still, still, [](double t) { return 0.35 * std::sin(2 * t); }, {-0.25, 0});
  const auto own = felt(alone(moves, {1, 0}), 20, 0);
  double largest = 0;
  for (const auto& [cd, cl, cm] : own) largest = std::max(largest, std::abs(cl));
  for (const bool first : {true, false}) {
    const auto there = felt(beside_circle(moves, {1, 0}, first), 20, first ? 0 : 1);
    // Either has its own error of a step: half a percent, as both routes are apart.
    const auto [cd, cl, cm] = off(own, there);
    CHECK(cd < 0.006 * largest);
    CHECK(cl < 0.01 * largest);
    CHECK(cm < 0.004 * largest);
  }
}

TEST_CASE("a circle that spins among others feels what it feels in axes that turn with it") {
  const double dt = 0.02;
  const auto circle = [] { return body::circle({}, 0.5); };
  const auto own = felt(test::coarse_flow(circle(), {.spin = {2}}, {1, 0}, 0.01, dt), 20, 0);
  std::vector<vortex::WallBody> bodies{{circle(), 160}, {circle(), 128, {0, far}}};
  const auto there =
      felt(test::coarse_flow(std::move(bodies), {{.spin = {2}}, {}}, {}, {1, 0}, 0.01, dt), 20, 0);
  // The pressure of a step acts where the wall is in its middle: left out, forces of up to 2 would
  // be turned by rate dt/2, 0.02 rad.
  const auto [cd, cl, cm] = off(own, there);
  CHECK(cd < 0.01);
  CHECK(cl < 0.01);
  CHECK(cm < 0.002);
}

TEST_CASE("the sheet that a moving body begins with is the one of the stream that it meets") {
  const Vec2 towed{-0.8, 0.3};
  const body::Course moves =
      course([&](double t) { return towed.x * t; }, [&](double t) { return towed.y * t; }, still);
  const auto sheet = [&](const vortex::Setup& setup) {
    vortex::Problem p = setup.problem;
    p.moving = setup.wall.get();
    stand(p, 0);
    vortex::Blobs blobs;
    return vortex::start(blobs, p).sheet;
  };
  const auto moving = sheet(beside_circle(moves, {}, true)),
             standing = sheet(alone({}, -1.0 * towed));
  for (std::size_t i = 0; i < standing.size(); ++i)  // potential of the circle: (1/60)^2/4 of U
    CHECK(moving[i] == Approx(standing[i]).margin(2e-4));
}

TEST_CASE("each of two bodies keeps the circulation that its own turning asks for") {
  // A quarter apart, one turns faster and faster.
  std::vector<vortex::WallBody> bodies{{body::circle({}, 0.5), 128}, {ellipse(), 160, {0, 1.2}}};
  std::vector<body::Motion> own{{.course = course(still, still, [](double t) { return t * t; })},
                                {}};
  vortex::VortexSolver solver(
      test::coarse_flow(std::move(bodies), std::move(own), {}, {1, 0}, 0.01, 0.02));
  for (int k = 0; k < 10; ++k) solver.step(silent);
  CHECK(std::abs(flow::measured(solver.measures(), "circulation")) < 1e-12);
  double all = 0;
  for (const double gamma : solver.blobs().gamma) all += gamma;
  const double area = std::numbers::pi / 4;
  CHECK(all == Approx(-2 * area * 2 * solver.time()).epsilon(1e-3));  // of panels: (pi/128)^2
  const auto each = solver.forces_on_each();
  const auto together = *solver.force();
  REQUIRE(each.size() == 2);
  for (const auto part : {&flow::Force::pressure, &flow::Force::friction, &flow::Force::frame}) {
    const Vec2 sum = each[0].*part + each[1].*part;
    CHECK(sum.x == Approx((together.*part).x).margin(1e-14));
    CHECK(sum.y == Approx((together.*part).y).margin(1e-14));
  }
}

TEST_CASE("both routes tell the same of two bodies that pass each other closely") {
  std::vector<vortex::WallBody> bodies{{body::circle({}, 0.5), 128}, {ellipse(), 160, {0.6, 1.0}}};
  std::vector<body::Motion> own{
      {}, {.course = course([](double t) { return -t; }, still, [](double t) { return 0.5 * t; })}};
  const auto rows =
      test::told(test::coarse_flow(std::move(bodies), std::move(own), {}, {}, 0.01, 0.01), 60);
  const double largest = std::max(test::largest(rows.cd_wall), test::largest(rows.cl_wall));
  // The same share of the largest force as of a single body that flaps.
  CHECK(test::apart(rows.cd_impulse, rows.cd_wall) < 0.01 * largest);
  CHECK(test::apart(rows.cl_impulse, rows.cl_wall) < 0.01 * largest);
}

TEST_CASE("a run of bodies that move against each other resumes to the bit") {
  const body::Course pitch = course(still, still, [](double t) { return 0.9 * t; });
  vortex::VortexSolver solver(beside_circle(pitch, {1, 0}, false));
  for (int k = 0; k < 4; ++k) solver.step(silent);
  CHECK(flow::measured(solver.measures(), "body_angle_2") ==
        Approx(0.9 * solver.time() * 180 / std::numbers::pi).epsilon(1e-9));
  flow::State state;
  solver.save(state);
  vortex::VortexSolver again(beside_circle(pitch, {1, 0}, false));
  again.restore(4, solver.columns(), state);
  solver.step(silent);
  again.step(silent);
  CHECK(solver.blobs().x == again.blobs().x);
  CHECK(solver.blobs().gamma == again.blobs().gamma);
  CHECK(solver.forces_on_each()[1].pressure == again.forces_on_each()[1].pressure);
}

TEST_CASE("on the wall of a body that turns or goes, C_p is that of the same in its own axes") {
  const body::Course moves =
      course([](double t) { return -0.8 * t; }, still, [](double t) { return 0.6 * t; });
  const auto after = [](vortex::Setup setup) {
    vortex::VortexSolver solver(std::move(setup));
    for (int k = 0; k < 12; ++k) solver.step(silent);
    return std::pair{solver.frame_table(), solver.frame_rows()};
  };
  const auto [columns, own] = after(alone(moves, {0.2, 0}));
  const auto [columns_there, there] = after(beside_circle(moves, {0.2, 0}, false));
  REQUIRE(columns_there.columns.size() == columns.columns.size() + 1);
  const std::size_t width = columns.columns.size(), first = 128 * (width + 1);
  for (std::size_t i = 0; i < 160; ++i) {
    const double *a = &own[i * width], *b = &there[first + i * (width + 1)];
    CHECK(b[2] == 2);                          // the number of the body
    CHECK(b[6] == Approx(a[5]).margin(0.05));  // C_p, of up to 2; steps of 0.02 make noise
    CHECK(b[7] == Approx(a[6]).margin(0.02));  // C_f
  }
}

TEST_CASE("the pressure around a body that turns and goes is that of the same in its own frame") {
  const body::Course moves = course([](double t) { return -0.8 * t + 0.3 * t * t; }, still,
                                    [](double t) { return 0.6 * t; });
  const auto after = [](vortex::Setup setup) {
    auto solver = std::make_unique<vortex::VortexSolver>(std::move(setup));
    for (int k = 0; k < 12; ++k) solver->step(silent);
    return solver;
  };
  // The frame of the first is that of its centre, in which the scene stands still.
  const auto own = after(alone(moves, {0.2, 0})),
             there = after(beside_circle(moves, {0.2, 0}, true));
  const Vec2 place = moves.at(own->time()).place;
  std::vector<double> x, y, moved, unmoved;
  for (const double r : {0.55, 0.8, 1.5, 4.0})
    for (int k = 0; k < 12; ++k) {
      x.push_back(r * std::cos(k * std::numbers::pi / 6));
      y.push_back(r * std::sin(k * std::numbers::pi / 6));
      moved.push_back(x.back() + place.x);
    }
  const std::vector<double> a = own->pressure({x, y}), b = there->pressure({moved, y});
  double largest = 0;
  for (const double p : a) largest = std::max(largest, std::abs(p));
  CHECK(largest > 0.2);
  // As C_p on the wall, of which the field is a sum.
  for (std::size_t k = 0; k < a.size(); ++k) CHECK(b[k] == Approx(a[k]).margin(0.02));
}
