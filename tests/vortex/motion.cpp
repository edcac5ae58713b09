#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "vortex/coarse_flow.hpp"
#include "vortex/motions.hpp"

using namespace vortree;
using test::apart;
using test::course;
using test::largest;
using test::still;
using test::Told;
using test::told;

namespace {

const double pi = std::numbers::pi;

/// An ellipse of length 1 at Re = 100 or so, coarse enough for a test.
vortex::Setup ellipse(double incidence, Vec2 stream, const body::Course& moves, double dt = 0.02) {
  return test::coarse_flow(body::ellipse({}, 0.5, 0.25, incidence), {.course = moves}, stream, 0.01,
                           dt);
}

}  // namespace

TEST_CASE("a body turned by its motion feels what one feels that stands so") {
  const Told stands = told(ellipse(0.4, {1, 0}, {}), 12);
  const Told turned =
      told(ellipse(0, {1, 0}, course(still, still, [](double) { return -0.4; })), 12);
  CHECK(apart(stands.cd_impulse, turned.cd_impulse) < 0.002 * largest(stands.cd_impulse));
  CHECK(apart(stands.cl_impulse, turned.cl_impulse) < 0.004 * largest(stands.cd_impulse));
  CHECK(apart(stands.cd_wall, turned.cd_wall) < 0.002 * largest(stands.cd_impulse));
}

TEST_CASE("a body that is towed feels what one feels in a stream") {
  const Told stands = told(ellipse(0.4, {1, 0}, {}), 12);
  const Told towed =
      told(ellipse(0.4, {0, 0}, course([](double t) { return -t; }, still, still)), 12);
  // Velocities differ by 1e-9, and with them now and then which blobs merge.
  CHECK(apart(stands.cd_impulse, towed.cd_impulse) < 5e-4 * largest(stands.cd_impulse));
  CHECK(apart(stands.cl_wall, towed.cl_wall) < 5e-4 * largest(stands.cd_impulse));
}

TEST_CASE("both routes tell the same force on a body that pitches about a pivot in a stream") {
  const body::Course pitch =
      course(still, still, [](double t) { return 0.35 * std::sin(2 * pi * t); }, {-0.25, 0.1});
  const Told coarse = told(ellipse(0, {1, 0}, pitch), 45),
             rows = told(ellipse(0, {1, 0}, pitch, 0.01), 90);
  const double far = apart(coarse.cd_impulse, coarse.cd_wall),
               near = apart(rows.cd_impulse, rows.cd_wall);
  CHECK(near < 0.004 * largest(rows.cl_impulse));
  CHECK(near < 0.75 * far);
  CHECK(apart(rows.cl_impulse, rows.cl_wall) < 0.004 * largest(rows.cl_impulse));
  CHECK(largest(rows.cl_impulse) > 2);
}

TEST_CASE("both routes tell the same force on a body that flaps and heaves in fluid at rest") {
  const body::Course flap =
      course([](double t) { return 0.1 * std::sin(3 * t); }, [](double t) { return 0.1 * t * t; },
             [](double t) { return 0.3 * (1 - std::cos(2 * pi * t)); }, {0.5, 0.3});
  const Told rows = told(ellipse(0.2, {}, flap), 45);
  CHECK(apart(rows.cd_impulse, rows.cd_wall) < 0.01 * largest(rows.cl_impulse));
  CHECK(apart(rows.cl_impulse, rows.cl_wall) < 0.01 * largest(rows.cl_impulse));
}

TEST_CASE("an ellipse that begins to turn about a pivot pushes the mass that potential flow has") {
  // The centre sets off at rate e x (-about); the fluid's impulse is that mass times it, per axis.
  const double a = 0.5, b = 0.25, rate = 2;
  const Vec2 about{-0.3, 0.2}, sets_off = -rate * left_of(about);
  vortex::Setup setup = ellipse(0, {},
                                course(
                                    still, still, [&](double t) { return rate * t; }, about));
  const vortex::VortexSolver solver(std::move(setup));
  const double area = pi * a * b;
  const Vec2 impulse = solver.force()->impulse;  // of fluid, and of the body as if it were fluid
  CHECK(impulse.x - area * sets_off.x == Approx(pi * b * b * sets_off.x).epsilon(1e-4));
  CHECK(impulse.y - area * sets_off.y == Approx(pi * a * a * sets_off.y).epsilon(1e-4));
}

TEST_CASE("places and velocities are told in axes that do not turn") {
  const auto after_steps = [](vortex::Setup setup) {
    auto solver = std::make_unique<vortex::VortexSolver>(std::move(setup));
    for (int k = 0; k < 5; ++k) solver->step([](std::string_view) {});
    return solver;
  };
  const auto stands = after_steps(ellipse(0.4, {1, 0}, {}));
  const auto turned =
      after_steps(ellipse(0, {1, 0}, course(still, still, [](double) { return -0.4; })));
  const std::vector<double> x{0.6, 0.1, -0.2, 0.52}, y{-0.4, 0.4, -0.3, -0.22};
  const flow::Samples a = stands->sample({x, y}), b = turned->sample({x, y});
  for (std::size_t i = 0; i < x.size(); ++i) {
    CHECK(b.u[i] == Approx(a.u[i]).margin(0.005));
    CHECK(b.v[i] == Approx(a.v[i]).margin(0.005));
    CHECK(b.omega[i] == Approx(a.omega[i]).margin(0.1));
  }
  const flow::Columns columns = turned->columns();
  const std::vector<double> gamma = flow::column(columns, "gamma"), at = flow::column(columns, "y");
  double moment = 0;
  for (std::size_t i = 0; i < gamma.size(); ++i) moment += gamma[i] * at[i];
  CHECK(moment == Approx(turned->force()->impulse.x).epsilon(0.02));  // but for what walls fold
}

TEST_CASE("a run of a body that turns resumes to the bit") {
  const body::Course pitch = course(still, still, [](double t) { return 0.9 * t; });
  const auto silent = [](std::string_view) {};
  vortex::VortexSolver solver(ellipse(0, {1, 0}, pitch));
  for (int k = 0; k < 5; ++k) solver.step(silent);
  CHECK(flow::measured(solver.measures(), "body_angle") ==
        Approx(0.9 * solver.time() * 180 / pi).epsilon(1e-9));
  flow::State state;
  solver.save(state);
  vortex::VortexSolver again(ellipse(0, {1, 0}, pitch));
  again.restore(5, solver.columns(), state);
  solver.step(silent);
  again.step(silent);
  CHECK(solver.blobs().x == again.blobs().x);
  CHECK(solver.blobs().gamma == again.blobs().gamma);
  CHECK(solver.force()->impulse.y == again.force()->impulse.y);
}
