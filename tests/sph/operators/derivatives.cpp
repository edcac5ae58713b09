#include "sph/operators/derivatives.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "sph/operators/clouds.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

Cloud carrying(Cloud cloud, std::uint64_t seed) {
  Chance chance(seed);
  for (const auto field : carried)
    for (double& value : cloud.*field) value = 2 * chance.real() - 1;
  return cloud;
}

/// sum |w| 2: what a sum of n terms may lose is n times the round-off of it.
double rounding(const Stencils& stencils, std::size_t i, int e) {
  double sum = 0;
  stencils.for_each(
      i, [&](std::size_t, std::size_t slot) { sum += 2 * std::abs(stencils.weight(e, slot)); });
  return static_cast<double>(stencils.length(i)) * 2.2e-16 * sum;
}

}  // namespace

TEST_CASE(
    "slopes of all that is carried are the sums over neighbors, for any number of particles") {
  const Cloud whole = uneven_cloud(9, 41);
  for (std::size_t n : {1, 2, 3, 7, 8, 9, 100, static_cast<int>(whole.size())}) {
    Cloud part;
    for (std::size_t i = 0; i < n; ++i)
      part.add(whole.at(i), whole.spacing[i], ParticleKind::fluid);
    const Cloud cloud = carrying(part, 42);
    Stencils stencils;
    stencils.renew(cloud, {});
    std::vector<Slopes> slopes;
    find_slopes(cloud, stencils, slopes);
    std::vector<double> divergence(n), x(n), y(n);
    find_divergence(cloud.u, cloud.v, stencils, divergence);
    find_gradient(cloud.p, stencils, x, y);
    REQUIRE(slopes.size() == n);
    for (std::size_t i = 0; i < n; ++i) {
      std::array<std::array<double, 5>, carried_count> sums;
      for (std::size_t field = 0; field < carried_count; ++field) {
        sums[field] = summed(stencils, cloud.*carried[field], i);
        const auto found = listed(slopes[i][field]);
        for (int e = 0; e < 5; ++e)
          REQUIRE(std::abs(found[e] - sums[field][e]) <= rounding(stencils, i, e));
      }
      const double bound = 2 * (rounding(stencils, i, 0) + rounding(stencils, i, 1));
      CHECK(std::abs(vorticity(slopes[i]) - (sums[1][0] - sums[0][1])) <= bound);
      CHECK(std::abs(divergence[i] - (sums[0][0] + sums[1][1])) <= bound);
      CHECK(std::abs(x[i] - sums[4][0]) <= bound);
      CHECK(std::abs(y[i] - sums[4][1]) <= bound);
    }
  }
}

TEST_CASE("what a particle carries follows a quadratic field to any place") {
  Cloud cloud = uneven_cloud(12, 43);
  Chance chance(7);
  std::vector<Polynomial> fields;
  for (std::size_t k = 0; k < carried_count; ++k) fields.emplace_back(2, chance);
  for (std::size_t field = 0; field < carried_count; ++field)
    cloud.*carried[field] = values(cloud, fields[field]);
  Stencils stencils;
  stencils.renew(cloud, {});
  std::vector<Slopes> slopes;
  find_slopes(cloud, stencils, slopes);
  for (std::size_t i = 0; i < cloud.size(); i += 5) {
    const Vec2 by{0.1 * chance.real(), -0.1 * chance.real()};
    const auto there = carried_at(cloud, i, slopes[i], by);
    for (std::size_t field = 0; field < carried_count; ++field)
      CHECK(there[field] == Approx(fields[field](cloud.at(i) + by)).margin(1e-10));
  }
}

TEST_CASE("first derivatives err by the order of the degree, second ones by one less") {
  constexpr double k = 2 * std::numbers::pi;
  const auto errors = [&](int n, const OperatorOptions& options) {
    const Cloud cloud = uneven_cloud(n, 44, 0.1, false);
    Stencils stencils;
    stencils.renew(cloud, options);
    const auto f = values(cloud, [](Vec2 at) { return std::sin(k * at.x) * std::cos(k * at.y); });
    double first = 0, second = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const auto [x, y, xx, xy, yy] = summed(stencils, f, i);
      const Vec2 at = cloud.at(i);
      const double sx = std::sin(k * at.x), cx = std::cos(k * at.x), sy = std::sin(k * at.y),
                   cy = std::cos(k * at.y);
      first += std::pow(x - k * cx * cy, 2) + std::pow(y + k * sx * sy, 2);
      second += std::pow(xx + k * k * sx * cy, 2) + std::pow(yy + k * k * sx * cy, 2) +
                std::pow(xy + k * k * cx * sy, 2);
    }
    return std::pair{std::sqrt(first / cloud.size()), std::sqrt(second / cloud.size())};
  };
  for (const OperatorOptions options : {OperatorOptions{2, 2.8, 1}, {4, 3.9, 1}}) {
    const auto [first, second] = errors(20, options);
    const auto [finer_first, finer_second] = errors(40, options);
    CAPTURE(options.degree, first, finer_first, second, finer_second);
    CHECK(std::log2(first / finer_first) > options.degree - 0.3);
    CHECK(std::log2(second / finer_second) > options.degree - 1.3);
  }
}
