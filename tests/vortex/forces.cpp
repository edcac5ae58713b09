#include "vortex/forces.hpp"

#include <catch2/catch.hpp>

#include "cylinder_flow.hpp"
#include "flows.hpp"

using namespace vortree;
using vortex::Blobs;
using vortex::Vec2;
using vortex::Wall;

namespace {

constexpr double pi = std::numbers::pi, radius = 0.5, nu = 2e-3, dt = 0.01;

Wall wall_of(int panels) {
  return Wall(vortex::circle({}, radius), panels);
}

double wall_vorticity_of_all(const Blobs& blobs, Vec2 at) {
  double sum = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const Vec2 d = at - blobs.centre(i);
    const double s2 = blobs.sigma[i] * blobs.sigma[i];
    sum += 2 * blobs.gamma[i] / (pi * s2) * std::exp(-dot(d, d) / s2);
  }
  return sum;
}

/// nu int omega t ds of blobs alone, on a wall so fine that the rule is exact.
Vec2 friction_by_quadrature(const Blobs& blobs) {
  constexpr int count = 2000;
  Vec2 sum;
  for (int k = 0; k < count; ++k) {
    const double theta = 2 * pi * k / count;
    const double omega =
        wall_vorticity_of_all(blobs, {radius * std::cos(theta), radius * std::sin(theta)});
    sum = sum + (nu * omega * 2 * pi * radius / count) * Vec2{-std::sin(theta), std::cos(theta)};
  }
  return sum;
}

/// Blobs all around, as strong as a sheet gamma = sin theta, at one distance.
Blobs hand_made_layer(double distance, double sigma) {
  constexpr int count = 500;
  Blobs blobs;
  for (int k = 0; k < count; ++k) {
    const double theta = 2 * pi * k / count, r = radius + distance;
    blobs.append({r * std::cos(theta), r * std::sin(theta)},
                 std::sin(theta) * 2 * pi * radius / count, sigma);
  }
  return blobs;
}

double off(Vec2 a, Vec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

TEST_CASE("wall vorticity is the sum of all folded cores, but for the ends beyond four cores") {
  const Wall wall = wall_of(100);
  for (double wide : {0.02, 0.15}) {
    const Blobs blobs = test::layer(500, radius, 0.1, 0.01, wide);
    double peak = 0;
    for (std::size_t i = 0; i < blobs.size(); ++i)
      peak += 2 * std::abs(blobs.gamma[i]) / (pi * blobs.sigma[i] * blobs.sigma[i]);
    const auto omega = wall_vorticity(blobs, std::vector<double>(100), wall, nu, dt);
    for (std::size_t i = 0; i < wall.panels(); ++i)
      CHECK(std::abs(omega[i] - wall_vorticity_of_all(blobs, wall.middle(i))) < 1.2e-7 * peak);
  }
}

TEST_CASE("a sheet let in at an even rate makes the wall vorticity of its ages' mean") {
  // (1/dt) int_0^dt (pi nu tau)^(-1/2) dtau, by the midpoint rule in sqrt(tau).
  double mean = 0;
  constexpr int n = 1000;
  for (int k = 0; k < n; ++k) {
    const double root = std::sqrt(dt) * (k + 0.5) / n;
    mean += 2 * root / std::sqrt(pi * nu * root * root) / (std::sqrt(dt) * n);
  }
  const Wall wall = wall_of(16);
  std::vector<double> sheet(16);
  sheet[3] = 2;
  const auto omega = wall_vorticity({}, sheet, wall, nu, dt);
  CHECK(omega[3] == Approx(2 * mean).epsilon(1e-12));
  CHECK(omega[4] == 0);
  CHECK(wall_vorticity({}, sheet, wall, 0, dt)[3] == 0);  // nothing enters without viscosity
}

TEST_CASE("the pressure force of the sheet a sin theta + c cos theta is pi R^2 (-a, c)/dt") {
  const Wall wall = wall_of(50);
  std::vector<double> sheet;
  for (std::size_t i = 0; i < wall.panels(); ++i) {
    const double theta = test::polar_angle(wall.middle(i));
    sheet.push_back(3 * std::sin(theta) + 2 * std::cos(theta) + 0.7 + std::cos(2 * theta));
  }
  const Vec2 force = pressure_force(sheet, wall, dt);
  CHECK(force.x == Approx(-3 * pi * radius * radius / dt).epsilon(1e-13));
  CHECK(force.y == Approx(2 * pi * radius * radius / dt).epsilon(1e-13));
}

TEST_CASE("the friction of a layer is the integral of its wall vorticity, to (sigma/R)^2") {
  for (double sigma : {0.01, 0.02, 0.04}) {
    for (double cores : {0.0, 0.7, 1.5}) {
      const Blobs blobs = hand_made_layer(cores * sigma, sigma);
      const Vec2 exact = friction_by_quadrature(blobs);
      const Vec2 force = friction_force(blobs, std::vector<double>(50), wall_of(50), nu, dt);
      CHECK(off(force, exact) < std::pow(sigma / radius, 2) * std::hypot(exact.x, exact.y));
    }
  }
}

TEST_CASE("the friction of single blobs is that of their integrals, wherever they are") {
  const Blobs blobs = test::layer(100, radius, 0.05, 0.01, 0.03);
  const Vec2 exact = friction_by_quadrature(blobs);
  const Vec2 force = friction_force(blobs, std::vector<double>(50), wall_of(50), nu, dt);
  CHECK(off(force, exact) < 2e-3 * std::hypot(exact.x, exact.y));
}

TEST_CASE("the friction of a sheet of sin theta is that of its wall vorticity, all of it drag") {
  const Wall wall = wall_of(60);
  std::vector<double> sheet;
  for (std::size_t i = 0; i < wall.panels(); ++i)
    sheet.push_back(-2 * std::sin(test::polar_angle(wall.middle(i))));
  const Vec2 force = friction_force({}, sheet, wall, nu, dt);
  CHECK(force.x == Approx(nu * 2 / std::sqrt(pi * nu * dt) * 2 * pi * radius).epsilon(1e-12));
  CHECK(std::abs(force.y) < 1e-14);
}
