#include "sph/motion/pressure_system.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sph/boundary/outer_box.hpp"
#include "sph/operators/clouds.hpp"
#include "sph/operators/derivatives.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

/// p = cos(2x + y) e^{y/2} and its derivatives.
struct Made {
  static double p(Vec2 at) { return std::cos(2 * at.x + at.y) * std::exp(at.y / 2); }
  static Vec2 gradient(Vec2 at) {
    const double e = std::exp(at.y / 2), c = std::cos(2 * at.x + at.y),
                 s = std::sin(2 * at.x + at.y);
    return {-2 * s * e, (0.5 * c - s) * e};
  }
  static double laplacian(Vec2 at) {
    const double e = std::exp(at.y / 2), c = std::cos(2 * at.x + at.y),
                 s = std::sin(2 * at.x + at.y);
    return (-4 * c - c + 0.25 * c - s) * e;
  }
};

/// The unit square with nodes around it, an outlet to the right.
Cloud square(int n, std::uint64_t seed = 81) {
  Cloud cloud = uneven_cloud(n, seed, 0.15, false);
  std::int32_t number = 0;
  for (const BoundaryNode& node : box_nodes({{0, 0}, {1, 1}}, 1.0 / n))
    cloud.add(node, node.normal.x < 0 ? ParticleKind::outlet : ParticleKind::outer, number++);
  sort(cloud);
  return cloud;
}

/// The relative error, less its mean where there is nothing that gives it.
double error_of(int n, bool outlets, std::uint64_t seed) {
  const Cloud cloud = square(n, seed);
  const OperatorOptions options{};
  Stencils stencils;
  stencils.renew(cloud, options);
  BoundaryFits fits;
  fits.renew(cloud, stencils, options);
  PressureSystem system;
  system.renew(cloud, stencils, fits, outlets);
  const std::vector<double> source = values(cloud, Made::laplacian);
  std::vector<double> given(cloud.size()), p(cloud.size(), 0);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud.kind[i] == ParticleKind::outlet && outlets)
      given[i] = Made::p(cloud.at(i));
    else if (!cloud.inside(i))
      given[i] = dot(cloud.normal(i), Made::gradient(cloud.at(i)));
  const Solved solved = system.solve(source, given, p, 1e-9);
  CHECK(solved.residual < 1e-9);
  double mean = 0, volume = 0, e = 0, size = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    volume += cloud.volume(i), mean += cloud.volume(i) * (p[i] - Made::p(cloud.at(i)));
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double d = p[i] - Made::p(cloud.at(i)) - (outlets ? 0 : mean / volume);
    e += d * d, size += 1;
  }
  return std::sqrt(e / size);
}

/// Of some clouds, as chance makes one better than another.
double error(int n, bool outlets) {
  double sum = 0;
  for (const std::uint64_t seed : {81, 82, 83, 84}) sum += std::pow(error_of(n, outlets, seed), 2);
  return std::sqrt(sum / 4);
}

}  // namespace

TEST_CASE("a pressure with slopes at walls and values at an outlet is found to second order") {
  const double coarse = error(16, true), fine = error(32, true);
  CAPTURE(coarse, fine);
  CHECK(fine < 5e-3);
  CHECK(std::log2(coarse / fine) > 1.6);
}

TEST_CASE("a pressure with slopes all around is found to second order, but for its mean") {
  const double coarse = error(16, false), fine = error(32, false);
  CAPTURE(coarse, fine);
  CHECK(fine < 5e-3);
  CHECK(std::log2(coarse / fine) > 1.6);
}

TEST_CASE("a pressure that nothing but slopes give has a mean of 0") {
  const Cloud cloud = square(12);
  Stencils stencils;
  stencils.renew(cloud, {});
  BoundaryFits fits;
  fits.renew(cloud, stencils, {});
  PressureSystem system;
  system.renew(cloud, stencils, fits, false);
  const std::vector<double> source(cloud.size(), 1), given(cloud.size(), -0.25);
  std::vector<double> p(cloud.size(), 100);
  system.solve(source, given, p, 1e-6);
  double mean = 0, size = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    mean += cloud.volume(i) * p[i], size += cloud.volume(i) * std::abs(p[i]);
  // What is left of the first guess, 100, and of the constant that GMRES adds.
  CHECK(std::abs(mean) < 1e-12);
  CHECK(size > 0.01);
}

TEST_CASE("a periodic pressure is found whatever the mean of its source is") {
  constexpr double k = 2 * std::numbers::pi;
  const Cloud cloud = uneven_cloud(24, 82, 0.1, false);
  const OperatorOptions options{4, 3.9, 1};
  Stencils stencils;
  stencils.renew(cloud, options);
  BoundaryFits fits;
  fits.renew(cloud, stencils, options);
  CHECK(fits.nodes().empty());
  PressureSystem system;
  system.renew(cloud, stencils, fits, true);
  const auto exact = values(cloud, [](Vec2 at) { return std::sin(k * at.x) * std::cos(k * at.y); });
  std::vector<double> first;
  for (const double mean : {0.0, 5.0}) {
    std::vector<double> source(cloud.size()), given(cloud.size(), 0), p(cloud.size(), 0);
    for (std::size_t i = 0; i < cloud.size(); ++i) source[i] = -2 * k * k * exact[i] + mean;
    system.solve(source, given, p, 1e-8);
    double e = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) e += std::pow(p[i] - exact[i], 2);
    CHECK(std::sqrt(e / static_cast<double>(cloud.size())) < std::pow(k / 24, 4));  // (k s)^4
    if (first.empty()) first = p;
    for (std::size_t i = 0; i < cloud.size(); ++i) CHECK(p[i] == Approx(first[i]).margin(1e-6));
  }
}

TEST_CASE("a system that is not solved is told of, with the residual") {
  const Cloud cloud = square(12);
  Stencils stencils;
  stencils.renew(cloud, {});
  BoundaryFits fits;
  fits.renew(cloud, stencils, {});
  PressureSystem system;
  system.renew(cloud, stencils, fits, true);
  const std::vector<double> source = values(cloud, Made::laplacian), given(cloud.size(), 1);
  std::vector<double> p(cloud.size(), 0);
  // Nothing is that exact in doubles.
  CHECK_THROWS_WITH(system.solve(source, given, p, 1e-30), Catch::Contains("a residual of"));
}
