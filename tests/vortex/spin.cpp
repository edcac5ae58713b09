#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shape.hpp"
#include "body/shapes/circle.hpp"
#include "exact/spinning_cylinder.hpp"
#include "vortex/solver.hpp"

using namespace vortree;

namespace {

const double pi = std::numbers::pi;

/// The inverse of a Laplace transform, by Gaver and Stehfest: 1e-9 where it is smooth, some 1e-6 in
/// the flanks of a front.
double inverse(const std::function<long double(long double)>& transform, double t) {
  constexpr int n = 18;
  const auto factorial = [](int k) { return std::tgammal(k + 1.0L); };
  const long double unit = std::log(2.0L) / t;
  long double sum = 0;
  for (int i = 1; i <= n; ++i) {
    long double weight = 0;
    for (int k = (i + 1) / 2; k <= std::min(i, n / 2); ++k)
      weight += std::pow(static_cast<long double>(k), n / 2) * factorial(2 * k) /
                (factorial(n / 2 - k) * factorial(k) * factorial(k - 1) * factorial(i - k) *
                 factorial(2 * k - i));
    sum += ((n / 2 + i) % 2 ? -1 : 1) * weight * transform(i * unit);
  }
  return static_cast<double>(sum * unit);
}

long double k(int order, long double x) {
  return x > 11000 ? 0 : std::cyl_bessel_kl(order, x);
}

/// A circle of radius 0.5 whose wall moves with speed 1, at Re = 100, coarse enough for a test.
vortex::Setup spinning(double rate, Vec2 centre = {}) {
  constexpr double nu = 0.01, dt = 0.02;
  vortex::Setup made{.problem = {.flow = {{}, nu, {.spin = {rate}}},
                                 .dt = dt,
                                 .advecting_cores = std::numbers::sqrt2,
                                 .sigma_0 = std::sqrt(2 * nu * dt),
                                 .splitting = {.sigma_max = std::sqrt(8 * nu * dt)},
                                 .merging = {.tolerance = 0.04,
                                             .reach = 3,
                                             .sigma_max = 1.1 * std::sqrt(8 * nu * dt)},
                                 .faintest = 1e-12,
                                 .sums = {.tolerance = 1e-5, .cores = fmm::Cores::mean}},
                     .scales = {.body = true, .impulsive = true},
                     .origin = {centre}};
  made.wall = std::make_shared<vortex::MovingWall>(body::circle({}, 0.5), 128, true);
  return made;
}

}  // namespace

TEST_CASE("the flow around a cylinder that begins to spin is what the Laplace transform gives") {
  for (const double nt : {1e-5, 1e-3, 0.1, 1.0, 10.0})
    for (const double out : {0.0, 0.5, 1.0, 2.0, 4.0, 8.0}) {
      const exact::SpinningCylinder c{1.5, 1, 1};
      const double layer = std::sqrt(nt), r = 1 + out * layer, off = out == 0 ? 2e-8 : 6e-6;
      CAPTURE(nt, out);
      const double swirl = inverse(
          [&](long double s) {
            const long double q = std::sqrt(s);
            return k(1, q * r) / (s * k(1, q));
          },
          nt);
      const double vorticity = inverse(
          [&](long double s) {
            const long double q = std::sqrt(s);
            return -q * k(0, q * r) / (s * k(1, q));
          },
          nt);
      CHECK(c.swirl(r, nt) == Approx(1.5 * swirl).margin(off));
      CHECK(c.vorticity(r, nt) * layer == Approx(1.5 * vorticity * layer).margin(off));
    }
}

TEST_CASE("the flow around a cylinder that spins obeys the equation of diffusion, and its walls") {
  const exact::SpinningCylinder c{2, 0.5, 0.01};
  CHECK(c.swirl(0.5, 0.3) == Approx(1).epsilon(1e-8));
  CHECK(c.swirl(0.5, 30) == Approx(1).epsilon(1e-8));
  CHECK(c.swirl(0.7, 1e6) == Approx(0.5 / 0.7).epsilon(0.1));  // a vortex, after very long
  for (const double r : {0.52, 0.6, 0.8}) {
    const double h = 1e-3, t = 1;
    const double rate = (c.swirl(r, t + h) - c.swirl(r, t - h)) / (2 * h);
    const double slope = (c.vorticity(r + h, t) - c.vorticity(r - h, t)) / (2 * h);
    CHECK(rate == Approx(c.nu * slope).epsilon(1e-4));
    const double turned = ((r + h) * c.swirl(r + h, t) - (r - h) * c.swirl(r - h, t)) / (2 * h * r);
    CHECK(c.vorticity(r, t) == Approx(turned).epsilon(1e-4));
  }
}

TEST_CASE("the first sheet of a circle that spins is its wall's speed, all around") {
  vortex::Setup setup = spinning(2);
  vortex::Blobs blobs;
  setup.problem.moving = setup.wall.get();
  stand(setup.problem, 0);
  const vortex::Wake wake = vortex::start(blobs, setup.problem);
  for (const double gamma : wake.sheet) CHECK(gamma == Approx(-1).epsilon(1e-12));
  double sum = 0;
  for (const double gamma : blobs.gamma) sum += gamma;
  CHECK(sum == Approx(-2 * 2 * pi / 4).epsilon(1e-12));  // -2 Omega A
}

TEST_CASE(
    "a circle that spins in fluid at rest drags it along as the exact flow, and feels no pull") {
  for (const double rate : {2.0, -2.0}) {
    vortex::VortexSolver solver(spinning(rate));
    const auto silent = [](std::string_view) {};
    while (solver.steps() < 25) solver.step(silent);
    const exact::SpinningCylinder exact{rate, 0.5, 0.01};
    const double t = solver.time();
    for (const double r : {0.53, 0.56, 0.6, 0.65, 0.7, 0.8}) {
      const double angle = 1.1 + r;
      const std::vector<double> x{r * std::cos(angle)}, y{r * std::sin(angle)};
      const flow::Samples found = solver.sample({x, y});
      CAPTURE(rate, r);
      CHECK(found.v[0] * x[0] - found.u[0] * y[0] ==
            Approx(r * exact.swirl(r, t)).margin(0.02 * 0.5));
      CHECK(found.u[0] * x[0] + found.v[0] * y[0] == Approx(0).margin(0.01 * 0.5));
    }
    CHECK(flow::measured(solver.measures(), "circulation") == Approx(0).margin(1e-10));
    const flow::Force force = *solver.force();
    for (const double pull : {force.impulse.x, force.impulse.y, force.friction.x, force.friction.y})
      CHECK(pull == Approx(0).margin(2e-3));
  }
}

TEST_CASE("in a stream a circle that spins anticlockwise is pushed to the right of the stream") {
  vortex::Setup setup = spinning(2);
  setup.problem.flow.stream = {1, 0};
  vortex::VortexSolver solver(std::move(setup));
  while (solver.steps() < 15) solver.step([](std::string_view) {});
  const double before = solver.force()->impulse.y;
  while (solver.steps() < 25) solver.step([](std::string_view) {});
  CHECK(solver.force()->impulse.y > before + 0.01);  // the body feels the opposite
}

TEST_CASE("a circle spins in the same way wherever it lies") {
  vortex::VortexSolver here(spinning(2)), there(spinning(2, {16, -8}));
  for (int n = 0; n < 3; ++n)
    for (vortex::VortexSolver* solver : {&here, &there}) solver->step([](std::string_view) {});
  CHECK(here.blobs() == there.blobs());
  const std::vector<double> x{0.6}, y{0.1}, far_x{16.6}, far_y{-7.9};
  CHECK(here.sample({x, y}).u[0] == Approx(there.sample({far_x, far_y}).u[0]).epsilon(1e-9));
}
