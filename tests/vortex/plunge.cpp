#include <catch2/catch.hpp>
#include <complex>

#include "body/motion.hpp"
#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "body/shapes/naca0012.hpp"
#include "exact/theodorsen.hpp"
#include "vortex/cylinder_flow.hpp"
#include "vortex/step.hpp"

using namespace vortree;
using body::Plunge;
using test::Complex;
using vortex::Flow;

namespace {

constexpr double pi = std::numbers::pi;

/// Forces on a body that plunges, in its own frame, over steps: by impulse, and by the wall.
struct Forces {
  std::vector<double> time;
  std::vector<Vec2> by_impulse, by_wall;
};

Forces forces(vortex::Problem problem, int steps) {
  vortex::Blobs blobs;
  std::vector<vortex::Wake> wakes{start(blobs, problem)};
  Forces made;
  for (int k = 1; k <= steps; ++k) {
    wakes.push_back(step(blobs, problem, k, [](std::string_view) {}));
    problem.time = k * problem.dt;
    const Vec2 rate = (1 / problem.dt) * (wakes[k].moment - wakes[k - 1].moment);
    made.time.push_back((k - 0.5) * problem.dt);
    made.by_impulse.push_back({-rate.y, rate.x});
    made.by_wall.push_back(wakes[k].pressure[0].force +
                           0.5 * (wakes[k - 1].friction[0].force + wakes[k].friction[0].force));
  }
  return made;
}

/// The component at exp(i omega t) of a series over whole periods.
Complex component(const Forces& forces, const std::vector<Vec2>& values, Vec2 along, double omega,
                  std::size_t from) {
  Complex sum = 0;
  for (std::size_t k = from; k < values.size(); ++k)
    sum += dot(values[k], along) * std::polar(1.0, -omega * forces.time[k]);
  return 2.0 / static_cast<double>(values.size() - from) * sum;
}

vortex::Problem problem_of(const vortex::Wall& wall, const fmm::Options& velocity, Flow flow,
                           double dt, double core) {
  return {.flow = flow,
          .dt = dt,
          .sigma_0 = std::sqrt(flow.nu * dt),
          .splitting = {.sigma_max = core},
          .merging = {.tolerance = 0.01, .reach = 3, .sigma_max = std::sqrt(1.2) * core},
          .wall = &wall,
          .sums = velocity};
}

/// Mass that a body carries along without viscosity, per unit density: the impulse of the sheet
/// that it has at speed 1, less what the frame adds.
double added_mass(std::unique_ptr<body::Shape> shape, Vec2 along) {
  const vortex::Wall wall(std::move(shape), 200);
  const auto slip = wall.slip(-1.0 * along, vortex::Velocities(2 * wall.panels()), {}, {});
  const Vec2 moment = wall.first_moment(wall.sheet(slip, 0));
  return dot({moment.y, -moment.x}, along) - wall.area();
}

}  // namespace

TEST_CASE("the stream that a body sees is that of its velocity, and adds up to its way") {
  const Flow flow{{1, 0.2}, 0.01, {{{0.1, 0.3}, 0.7}}};
  Vec2 way;
  const int parts = 2000;
  for (int k = 0; k < parts; ++k)
    way = way + 1.3 / parts * flow.stream_at(0.4 + 1.3 * (k + 0.5) / parts);
  const Vec2 off = way - flow.way(0.4, 1.3);
  CHECK(std::hypot(off.x, off.y) < 1e-6);
  const double h = 1e-5;
  const Vec2 rate = 1 / (2 * h) * (flow.stream_at(1 + h) - flow.stream_at(1 - h));
  CHECK(rate.y == Approx(-flow.motion.at(1).acceleration.y).epsilon(1e-8));
}

TEST_CASE("areas of bodies") {
  CHECK(vortex::Wall(body::circle({3, 1}, 0.5), 60).area() == Approx(pi / 4).epsilon(1e-12));
  CHECK(vortex::Wall(body::ellipse({3, 1}, 0.5, 0.2, 0.3), 200).area() ==
        Approx(pi / 10).epsilon(1e-10));
  // 0.6 t of the polynomial's integral is 0.0822 chords^2 for t = 0.12.
  CHECK(vortex::Wall(body::naca0012({}, 1, 0.001, 0), 600).area() == Approx(0.0822).epsilon(5e-3));
}

TEST_CASE("a body without viscosity carries the mass along that is known: circle and ellipse") {
  CHECK(added_mass(body::circle({}, 0.5), {1, 0}) == Approx(pi / 4).epsilon(1e-10));
  CHECK(added_mass(body::ellipse({}, 0.5, 0.25, 0), {1, 0}) ==
        Approx(pi * 0.25 * 0.25).epsilon(1e-8));
  CHECK(added_mass(body::ellipse({}, 0.5, 0.25, 0), {0, 1}) ==
        Approx(pi * 0.5 * 0.5).epsilon(1e-8));
}

namespace {

/// By impulse and by the wall, relative: how far the force on a cylinder that trembles in a viscous
/// fluid is off what Stokes found, F = -pi R^2 (1 + 4 K1(z)/(z K0(z))) dV/dt, z = R sqrt(i
/// omega/nu), for small amplitudes.
std::pair<double, double> off_stokes(int panels, int period, double core) {
  const double nu = 0.01, radius = 0.5, frequency = 1, amplitude = 0.01;
  const vortex::Wall wall(body::circle({}, radius), panels);
  const auto velocity = fmm::Options{.tolerance = 1e-4, .cores = fmm::Cores::mean};
  const Plunge plunge{{amplitude, 0}, frequency};
  const Forces f =
      forces(problem_of(wall, velocity, {{}, nu, {plunge}}, 1.0 / period, core), 2 * period);
  const double omega = plunge.omega();
  const Complex z = radius * std::sqrt(Complex(0, omega / nu));
  const Complex ratio = 1.0 + 0.5 / z - 0.125 / (z * z) + 0.125 / (z * z * z);  // K1/K0
  const Complex exact =
      -pi * radius * radius * (1.0 + 4.0 * ratio / z) * (-omega * omega * amplitude);
  const double displaced = -wall.area() * omega * omega * amplitude;
  const auto off = [&](const auto& values) {
    const Complex ours = component(f, values, {1, 0}, omega, period) + displaced;
    return std::abs(ours - exact) / std::abs(exact);
  };
  return {off(f.by_impulse), off(f.by_wall)};
}

}  // namespace

TEST_CASE("a cylinder that trembles in a viscous fluid feels what Stokes found, by both routes") {
  // Layers are sqrt(2 nu/omega) = 0.056 thick: cores of four fifths of it, and of 0.57, with half
  // the step and half the panels. The error falls faster than their squares.
  const auto [coarse_impulse, coarse_wall] = off_stokes(80, 80, 0.045);
  const auto [impulse, by_wall] = off_stokes(160, 160, 0.0318);
  CAPTURE(coarse_impulse, coarse_wall, impulse, by_wall);
  CHECK(impulse < 0.008);
  CHECK(by_wall < 0.008);
  CHECK(impulse < 0.5 * coarse_impulse);
  CHECK(by_wall < 0.5 * coarse_wall);
}

TEST_CASE("Theodorsen's function: known values, and its ends") {
  const Complex tenth = exact::theodorsen_function(0.1), one = exact::theodorsen_function(1);
  CHECK(tenth.real() == Approx(0.8319).epsilon(1e-4));
  CHECK(tenth.imag() == Approx(-0.1723).epsilon(1e-3));
  CHECK(one.real() == Approx(0.5394).epsilon(1e-4));
  CHECK(one.imag() == Approx(-0.1003).epsilon(1e-3));
  CHECK(std::abs(exact::theodorsen_function(1e-6) - 1.0) < 2e-5);
  CHECK(std::abs(exact::theodorsen_function(500) - 0.5) < 1e-3);
  // Slowly: the quasi-steady lift 2 pi times the angle -dy/dt/U, y/b = exp(i omega t).
  CHECK(std::abs(exact::lift_of_plunge(1, 1e-4) / Complex(0, -2e-4 * pi) - 1.0) < 2e-3);
}
