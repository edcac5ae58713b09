#include "vortex/wall_pressure.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "exact/spinning_cylinder.hpp"
#include "vortex/coarse_flow.hpp"
#include "vortex/solver.hpp"

using namespace vortree;

namespace {

const double pi = std::numbers::pi;

/// A body of length 1, coarse enough for a test.
vortex::Setup beside(std::unique_ptr<body::Shape> shape, const body::Motion& motion = {},
                     Vec2 stream = {1, 0}, double nu = 0.01, double dt = 0.02, int panels = 160) {
  return test::coarse_flow(std::move(shape), motion, stream, nu, dt, panels);
}

/// C_p and C_f of each panel, and the middles and tangents they belong to.
struct Along {
  std::vector<double> cp, cf;

  explicit Along(const vortex::VortexSolver& solver) {
    const std::vector<double> rows = solver.frame_rows();
    for (std::size_t k = 0; k < rows.size(); k += 7) {
      cp.push_back(rows[k + 5]);
      cf.push_back(rows[k + 6]);
    }
  }
};

void go(vortex::VortexSolver& solver, int steps) {
  while (solver.steps() < steps) solver.step([](std::string_view) {});
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

}  // namespace

TEST_CASE("as an ellipse starts, the level of its pressure is that of potential flow") {
  // In the plane of the circle of radius c = (a + b)/2, w ds is the angle; z = e^-ia (zeta + (a^2 -
  // b^2)/(4 zeta)).
  using Complex = std::complex<double>;
  for (const auto& [a, b, incidence] :
       {std::array{0.5, 0.5, 0.0}, std::array{0.5, 0.3, 0.0}, std::array{0.5, 0.25, 0.4}}) {
    vortex::Setup setup = beside(body::ellipse({}, a, b, incidence));
    setup.problem.moving = setup.wall.get();
    stand(setup.problem, 0);
    vortex::Blobs blobs;
    vortex::start(blobs, setup.problem);
    const double c = (a + b) / 2, squares = (a * a - b * b) / 4;
    double potential = 0;
    constexpr int n = 400;
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * pi * (k + 0.5) / n;
      const Complex zeta = c * std::polar(1.0, angle);
      const double speed =
          2 * std::abs(std::sin(angle - incidence)) / std::abs(1.0 - squares / (zeta * zeta));
      potential += (1 - speed * speed) / 2 / n;
    }
    CAPTURE(a, b, incidence);
    CHECK(vortex::pressure_level(blobs, setup.problem) == Approx(potential).margin(0.015));
  }
}

TEST_CASE("around a circle that spins pressure is less by what turns the fluid") {
  const double rate = 2, R = 0.5, nu = 0.01;
  const exact::SpinningCylinder exact{rate, R, nu};
  double drop = 0;  // int u^2/r dr
  for (double h = 1e-3, r = R + h / 2; r < R + 0.8; r += h)
    drop += std::pow(exact.swirl(r, 0.5), 2) / r * h;
  const auto off = [&](double dt, int panels) {
    vortex::VortexSolver solver(beside(body::circle({}, R), {.spin = {rate}}, {}, nu, dt, panels));
    go(solver, static_cast<int>(std::lround(0.5 / dt)));
    const Along wall(solver);
    const double shear = nu * (exact.vorticity(R, 0.5) - 2 * rate);
    for (const double cp : wall.cp) CHECK(cp == Approx(mean(wall.cp)).margin(0.02));
    // A single panel feels which blobs have merged beside it.
    CHECK(mean(wall.cf) == Approx(2 * shear).epsilon(0.01));
    for (const double cf : wall.cf) CHECK(cf == Approx(2 * shear).epsilon(0.04));
    return std::abs(mean(wall.cp) + 2 * drop);
  };
  const double coarse = off(0.02, 160), fine = off(0.01, 220);
  CHECK(coarse < 0.01);
  CHECK(fine < 0.6 * coarse);  // as the square of the cores
}

TEST_CASE("pressure and friction along the wall add up to the force on it") {
  const body::Motion plunge{.plunge = {{0.05, 0.1}, 0.8}};
  for (const body::Motion& motion : {body::Motion{}, plunge}) {
    vortex::VortexSolver solver(beside(body::ellipse({0.1, 0.05}, 0.5, 0.25, 0.4), motion));
    const vortex::Wall wall(body::ellipse({0.1, 0.05}, 0.5, 0.25, 0.4), 160);
    go(solver, 40);
    const Along along(solver);
    Vec2 pressure, friction;
    double moment = 0;
    for (std::size_t i = 0; i < 160; ++i) {
      const Vec2 t = wall.tangent(i), n{t.y, -t.x};
      pressure += (-wall.panel_length(0) * along.cp[i] / 2) * n;
      friction += (wall.panel_length(0) * along.cf[i] / 2) * t;
      moment += -wall.panel_length(0) * along.cp[i] / 2 * dot(left_of(wall.middle(i)), n);
    }
    const flow::Force force = *solver.force();
    const Vec2 frame = wall.area() * motion.at(solver.time() - 0.01).acceleration;
    const double all = std::hypot(force.pressure.x + force.friction.x + frame.x,
                                  force.pressure.y + force.friction.y + frame.y);
    const Vec2 off = pressure - force.pressure - frame, rub = friction - force.friction;
    CHECK(std::hypot(off.x, off.y) < 0.0005 * all);
    CHECK(std::hypot(rub.x, rub.y) < 0.005 * all);
    const double of_frame =
        dot(left_of(wall.area_moment()), motion.at(solver.time() - 0.01).acceleration);
    CHECK(moment == Approx(force.pressure_moment + of_frame).margin(0.001 * all));
  }
}

TEST_CASE("their integrals are the drag at the wall that the report tells") {
  vortex::VortexSolver solver(beside(body::circle({}, 0.5)));
  const vortex::Wall wall(body::circle({}, 0.5), 160);
  flow::ForceHistory history({.body = true, .impulsive = true});
  history.add(*solver.force());
  for (int k = 0; k < 60; ++k) {
    solver.step([](std::string_view) {});
    history.add(*solver.force());
  }
  const Along along(solver);
  double drag = 0;
  for (std::size_t i = 0; i < 160; ++i) {
    const Vec2 t = wall.tangent(i);
    drag += wall.panel_length(0) * (-along.cp[i] * t.y + along.cf[i] * t.x);
  }
  CHECK(drag == Approx(flow::measured(history.of_last(), "cd_wall")).epsilon(0.005));
}

TEST_CASE("a body that is towed has the pressure of one in a stream, wherever its centre is") {
  vortex::VortexSolver stands(beside(body::circle({}, 0.5))),
      aside(beside(body::circle({0.2, 0.1}, 0.5)));
  std::vector<double> times, zeros(101), x;
  for (int i = 0; i <= 100; ++i) times.push_back(0.01 * i), x.push_back(-times.back());
  const body::Jets still = body::known_evenly(zeros, 0.01);
  const body::Course course(times, {body::known_evenly(x, 0.01), still, still}, {});
  vortex::VortexSolver towed(beside(body::circle({}, 0.5), {.course = course}, {0, 0}));
  for (vortex::VortexSolver* solver : {&stands, &aside, &towed}) go(*solver, 12);
  const Along a(stands), b(aside), c(towed);
  for (std::size_t i = 0; i < a.cp.size(); ++i) {
    CHECK(b.cp[i] == Approx(a.cp[i]).margin(0.02));
    CHECK(c.cp[i] == Approx(a.cp[i]).margin(0.02));
  }
  CHECK(mean(a.cp) < -0.5);
}
