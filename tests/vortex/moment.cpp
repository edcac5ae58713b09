#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "exact/spinning_cylinder.hpp"
#include "vortex/coarse_flow.hpp"
#include "vortex/solver.hpp"

using namespace vortree;

namespace {

const double pi = std::numbers::pi;

/// A body of length 1 in a stream of speed 1 or none, coarse enough for a test.
vortex::Setup beside(std::unique_ptr<body::Shape> shape, double nu, double dt,
                     const body::Motion& motion = {}, Vec2 stream = {1, 0}) {
  return test::coarse_flow(std::move(shape), motion, stream, nu, dt);
}

/// The ellipse that most of them are.
vortex::Setup ellipse(Vec2 centre, const body::Motion& motion = {}, Vec2 stream = {1, 0}) {
  return beside(body::ellipse(centre, 0.5, 0.25, 0.4), 0.01, 0.02, motion, stream);
}

/// What a run tells after each of some steps, but for the last.
struct Told {
  std::vector<double> t, cd, cl, cm;
};

Told told(vortex::Setup setup, int steps, const auto& look) {
  flow::ForceHistory history(setup.scales);
  vortex::VortexSolver solver(std::move(setup));
  history.add(*solver.force());
  Told rows;
  for (int k = 0; k < steps; ++k) {
    const double time = solver.time();
    solver.step([](std::string_view) {});
    history.add(*solver.force());
    look(solver);
    if (history.size() < 3) continue;
    const flow::Measures now = history.of_last_but_one();
    rows.t.push_back(time);
    rows.cd.push_back(flow::measured(now, "cd_wall"));
    rows.cl.push_back(flow::measured(now, "cl_wall"));
    rows.cm.push_back(flow::measured(now, "cm_wall"));
  }
  return rows;
}

Told told(vortex::Setup setup, int steps) {
  return told(std::move(setup), steps, [](const vortex::VortexSolver&) {});
}

double most(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

TEST_CASE("about another point a body feels its moment and that of its force") {
  const Vec2 centre{0.3, -0.15};
  const Told here = told(ellipse({}), 12), there = told(ellipse(centre), 12);
  for (std::size_t k = 0; k < here.t.size(); ++k) {
    const double of_force = centre.x * here.cl[k] - centre.y * here.cd[k];
    CHECK(std::abs(there.cm[k] - here.cm[k] - of_force) < 2e-3 * std::abs(of_force));
    CHECK(std::abs(of_force) > 0.1);
  }
}

TEST_CASE("so does one that is shaken, with what its frame hides") {
  const Vec2 centre{0.3, -0.15};
  const body::Motion plunge{.plunge = {{0.1, 0.2}, 0.8}};
  const Told here = told(ellipse({}, plunge), 12), there = told(ellipse(centre, plunge), 12);
  for (std::size_t k = 0; k < here.t.size(); ++k) {
    const double of_force = centre.x * here.cl[k] - centre.y * here.cd[k];
    CHECK(std::abs(there.cm[k] - here.cm[k] - of_force) < 0.01);
  }
  CHECK(most(here.cl) > 2);
}

TEST_CASE("a body that pitches feels the same, told about its pivot or about its centre") {
  // About the pivot its frame stands still, and all is the wall's own acceleration.
  const Vec2 centre{0.3, -0.15};
  std::vector<double> times, angle, zeros(101);
  for (int i = 0; i <= 100; ++i) {
    times.push_back(0.01 * i);
    angle.push_back(0.5 * std::sin(4 * times.back()));
  }
  const body::Jets turn = body::known_evenly(angle, 0.01), still = body::known_evenly(zeros, 0.01);
  const body::Motion about_centre{.course = {times, {still, still, turn}, -1 * centre}};
  const body::Motion about_pivot{.course = {times, {still, still, turn}, {}}};
  std::vector<double> cp[2];
  const auto keep = [](std::vector<double>& cp) {
    return [&cp](const vortex::VortexSolver& solver) {
      const std::vector<double> rows = solver.frame_rows();
      cp.clear();
      for (std::size_t k = 5; k < rows.size(); k += 7) cp.push_back(rows[k]);
    };
  };
  const Told a = told(ellipse({}, about_centre), 20, keep(cp[0])),
             b = told(ellipse(centre, about_pivot), 20, keep(cp[1]));
  // In the first row, of rates that go as 1/sqrt(t), they are 2 % apart.
  for (std::size_t k = 1; k < a.t.size(); ++k) {
    const Vec2 arm = Turn(about_pivot.at(a.t[k]).angle)(centre);
    const double of_force = arm.x * a.cl[k] - arm.y * a.cd[k];
    CAPTURE(a.t[k]);
    CHECK(std::abs(a.cl[k] - b.cl[k]) < 0.01 * most(a.cl));
    CHECK(std::abs(b.cm[k] - a.cm[k] - of_force) < 0.01 * most(b.cm));
  }
  CHECK(most(b.cm) > 0.5);
  REQUIRE(cp[0].size() == 160);
  for (std::size_t i = 0; i < 160; ++i)
    CHECK(cp[0][i] == Approx(cp[1][i]).margin(0.02 * most(cp[0])));
}

TEST_CASE("as it starts, an ellipse is turned across the stream by Munk's moment") {
  // (m_22 - m_11) U V about the centre, pi (a^2 - b^2) sin(2 incidence)/2 clockwise: nose up. What
  // goes as 1/sqrt(t) is odd about the centre and has no moment; what the thickness of the layer
  // does goes as sqrt(t).
  const double a = 0.5, b = 0.25, incidence = 0.4;
  const double munk = -pi * (a * a - b * b) * std::sin(2 * incidence) / 2;
  const auto at_start = [&](double dt) {
    return told(beside(body::ellipse({}, a, b, incidence), 2e-3, dt), 3).cm.front() / 2;
  };
  const double coarse = at_start(0.01), fine = at_start(0.005);
  const double root = std::numbers::sqrt2;
  CAPTURE(munk, coarse, fine);
  CHECK(fine == Approx(munk).epsilon(0.04));
  CHECK((root * fine - coarse) / (root - 1) == Approx(munk).epsilon(0.005));
}

TEST_CASE("the moment at the wall is the rate at which the flow's second moment grows") {
  // M = d/dt int omega |x|^2/2 dA - U . int omega x dA, of a body that does not turn: the other
  // route, of which the wall knows nothing.
  std::vector<double> second{0}, drift{0};
  const Told rows = told(ellipse({}), 40, [&](const vortex::VortexSolver& solver) {
    second.push_back(flow::measured(solver.measures(), "second_moment"));
    drift.push_back(-flow::measured(solver.measures(), "impulse_y"));  // U . int omega x
  });
  for (std::size_t k = 5; k < rows.t.size(); ++k) {
    const std::size_t n = k + 2;  // of the row's time in the lists
    REQUIRE(rows.t[k] == Approx(0.02 * static_cast<double>(n - 1)));
    const double grows = (second[n] - second[n - 2]) / (2 * 0.04);
    CAPTURE(rows.t[k]);
    CHECK(rows.cm[k] / 2 == Approx(grows - drift[n - 1]).margin(0.03 * most(rows.cm)));
  }
}

TEST_CASE("a circle that spins feels the friction of the exact flow, and no moment of pressure") {
  const double rate = 2, nu = 0.01, R = 0.5;
  const exact::SpinningCylinder exact{rate, R, nu};
  vortex::VortexSolver solver(beside(body::circle({}, R), nu, 0.02, {.spin = {rate}}, {}));
  for (int k = 1; k <= 25; ++k) {
    solver.step([](std::string_view) {});
    if (k < 10) continue;
    const double shear = exact.vorticity(R, solver.time()) - 2 * rate;
    const double torque = nu * shear * 2 * pi * R * R;
    CAPTURE(k);
    CHECK(solver.force()->friction_moment == Approx(torque).epsilon(0.01));
    CHECK(std::abs(solver.force()->pressure_moment) < 1e-3 * std::abs(torque));
  }
}

TEST_CASE("pressure does not turn a circle in a stream, though it spins") {
  vortex::VortexSolver solver(beside(body::circle({}, 0.5), 0.01, 0.02, {.spin = {1}}));
  for (int k = 0; k < 5; ++k) solver.step([](std::string_view) {});
  CHECK(std::abs(solver.force()->pressure_moment) < 1e-4);
  CHECK(std::abs(solver.force()->pressure.y) > 0.1);
}
