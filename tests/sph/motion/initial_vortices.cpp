#include "sph/motion/initial_vortices.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "sph/motion/potential_flow.hpp"
#include "sph/setup.hpp"

using namespace vortree;
using namespace vortree::sph;

namespace {

constexpr double pi = std::numbers::pi;

flow::InitialSettings lamb_oseen(double circulation, double core, std::array<double, 2> centre) {
  return {.kind = &flow::initial_flow("lamb_oseen"),
          .circulation = circulation,
          .core = core,
          .centre = centre};
}

using Complex = std::complex<double>;

/// u - i v of a vortex.
Complex vortex(double gamma, Complex z, Complex at) {
  return gamma / (2 * pi * Complex{0, 1} * (z - at));
}

struct StartErrors {
  double velocity, through;  // root mean square, relative; largest, through the wall
};

/// Of a vortex beside a circle, against its images by Milne-Thomson's circle theorem: together with
/// the body's own they have no circulation, or as much as it is to have.
StartErrors beside_circle(double s, double body = 0) {
  const double a = 0.5, gamma = 0.5;
  const std::shared_ptr<const body::Shape> shape = body::circle({}, a);
  const SphSetup setup{.scales = {},
                       .ambient = {},
                       .box = {{-4, -4}, {4, 4}},
                       .wanted = {shape, s, 3, 0.5, 2},
                       .confines = {{{-4, -4}, {4, 4}}, StandingBodies({stand(shape, s)}), 4},
                       .operators = {2, 2.8, 0, shape.get()}};
  Cloud cloud = starting_cloud(setup);
  Stencils stencils;
  stencils.renew(cloud, setup.operators);
  const double vortices = add_initial_vortices(cloud, lamb_oseen(gamma, 0.15, {0.8, 0.7}), {});
  CHECK(vortices == Approx(gamma).epsilon(1e-13));
  start_potential_flow(cloud, stencils, setup.operators, setup.ambient, setup.bodies(), true,
                       body - gamma);
  const Complex at{0.8, 0.7}, image = a * a / std::conj(at);
  double error = 0, size = 0, through = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Complex z{cloud.x[i], cloud.y[i]};
    if (std::abs(z - at) < 0.6) continue;  // the core is no point
    const Complex exact = vortex(gamma, z, at) - vortex(gamma, z, image) + vortex(body, z, 0);
    const Vec2 off = cloud.velocity(i) - Vec2{exact.real(), -exact.imag()};
    error += dot(off, off), size += std::norm(exact);
    if (cloud.kind[i] == ParticleKind::wall)
      through = std::max(through, std::abs(dot(cloud.velocity(i), cloud.normal(i))));
  }
  return {std::sqrt(error / size), through};
}

}  // namespace

TEST_CASE("a flow that begins with a vortex has its velocity") {
  const double gamma = 0.7, core = 0.3;
  Cloud cloud;
  for (int i = -20; i <= 20; ++i)
    for (int j = -20; j <= 20; ++j) cloud.add({0.1 * i, 0.1 * j}, 0.1, ParticleKind::fluid);
  for (double& u : cloud.u) u = 0.5;
  const Vec2 seen_from{3, -2}, centre{0.25, 0.15};
  add_initial_vortices(cloud, lamb_oseen(gamma, core, {3.25, -1.85}), seen_from);
  double error = 0, size = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec2 d = cloud.at(i) - centre;
    const double r2 = dot(d, d), f = -gamma / (2 * pi) * std::expm1(-r2 / (core * core)) / r2;
    const Vec2 exact{0.5 - f * d.y, f * d.x}, off = cloud.velocity(i) - exact;
    error += dot(off, off), size += f * f * r2;
  }
  CHECK(std::sqrt(error / size) < 5e-5);
}

TEST_CASE("a vortex beside a circle starts with its images in it, to second order") {
  const auto [coarse, coarse_through] = beside_circle(0.1);
  const auto [fine, fine_through] = beside_circle(0.05);
  CHECK(fine < 0.01);
  CHECK(coarse / fine > 2.5);  // 4, and disorder
  CHECK(coarse_through / fine_through > 2.5);
  CHECK(beside_circle(0.05, 0.5).velocity < 0.01);
}
