#include "sph/operators/boundary_fits.hpp"

#include <catch2/catch.hpp>

#include "sph/operators/clouds.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

/// Coordinates along a wall and away from it, turned by an angle.
struct Wall {
  double turn;
  Vec2 normal() const { return {-std::sin(turn), std::cos(turn)}; }
  Vec2 tangent() const { return {std::cos(turn), std::sin(turn)}; }
  Vec2 at(double t, double n) const { return t * tangent() + n * normal(); }
};

/// Nodes on a wall of length 2 and uneven particles on one side of it.
Cloud beside_wall(const Wall& wall, double s, std::uint64_t seed, double jitter = 0.25) {
  Cloud cloud;
  Chance chance(seed);
  const auto any = [&] { return 2 * jitter * (chance.real() - 0.5); };
  const int along = static_cast<int>(std::lround(2 / s));
  for (int i = 0; i < along; ++i) {
    const double t = (i + 0.5) * s - 1;
    cloud.add(BoundaryNode{wall.at(t, 0), wall.normal(), s}, ParticleKind::wall, i);
    for (int j = 1; j < 7; ++j)
      cloud.add(wall.at(t + s * any(), s * (j + any())), s * (1 + 0.4 * any()),
                ParticleKind::fluid);
  }
  return cloud;
}

BoundaryFits fits_of(const Cloud& cloud, const OperatorOptions& options = {}) {
  Stencils stencils;
  stencils.renew(cloud, options);
  BoundaryFits fits;
  fits.renew(cloud, stencils, options);
  return fits;
}

/// Nodes that do not see an end of the wall.
bool amid(const Cloud& cloud, const BoundaryFits::Node& node) {
  const Vec2 at = cloud.at(static_cast<std::size_t>(node.particle));
  return std::hypot(at.x, at.y) < 0.7;
}

double fitted(const BoundaryFits::Node& node, const std::vector<double>& f, double slope) {
  double sum = -node.lever * slope;
  for (const auto& [j, weight] : node.neighbors) sum += weight * f[j];
  return sum;
}

/// One node at the origin, its normal along y, and some particles.
Cloud few(std::initializer_list<Vec2> particles) {
  Cloud cloud;
  cloud.add(BoundaryNode{{0, 0}, {0, 1}, 1}, ParticleKind::wall, 0);
  for (const Vec2 at : particles) cloud.add(at, 1, ParticleKind::fluid);
  return cloud;
}

}  // namespace

TEST_CASE("a node's value is exact for polynomials of degree 2 whose slope is given") {
  for (const double turn : {0.0, 0.7, 2.5}) {
    const Wall wall{turn};
    for (const OperatorOptions options : {OperatorOptions{2, 2.8, 0}, {4, 3.9, 0}}) {
      const Cloud cloud = beside_wall(wall, 0.1, 21);
      const BoundaryFits fits = fits_of(cloud, options);
      Chance chance(3);
      const Polynomial p(2, chance);
      const std::vector<double> f = values(cloud, p);
      CHECK(fits.nodes().size() == 20);
      for (const BoundaryFits::Node& node : fits.nodes()) {
        if (!amid(cloud, node)) continue;
        const auto i = static_cast<std::size_t>(node.particle);
        const FieldSlopes d = p.slopes(cloud.at(i));
        const double slope = dot(wall.normal(), {d.x, d.y});
        // Five terms, a matrix of condition below 1e3, values of order one.
        CHECK(fitted(node, f, slope) == Approx(f[i]).margin(5 * 1e3 * 2.2e-16));
      }
    }
  }
}

TEST_CASE(
    "weights of a node add up to one, use what is inside alone, and a third of them at most is "
    "negative on a lattice") {
  for (const double jitter : {0.0, 0.1, 0.25}) {
    const Cloud cloud = beside_wall({0.3}, 0.1, 22, jitter);
    const BoundaryFits fits = fits_of(cloud);
    for (const BoundaryFits::Node& node : fits.nodes()) {
      double sum = 0, negative = 0, lever = 0;
      const auto i = static_cast<std::size_t>(node.particle);
      CHECK(cloud.kind[i] == ParticleKind::wall);
      CHECK(fits.of(i).particle == node.particle);
      for (const auto& [j, weight] : node.neighbors) {
        REQUIRE(cloud.inside(static_cast<std::size_t>(j)));
        sum += weight, negative -= std::min(weight, 0.0);
        lever += weight * dot(cloud.at(static_cast<std::size_t>(j)) - cloud.at(i), cloud.normal(i));
      }
      CHECK(sum == Approx(1).epsilon(1e-13));
      CHECK(node.lever == Approx(lever).epsilon(1e-12));
      CHECK(node.lever > 0);
      // (4 f_1 - f_2)/3 has a third of them, with the slope at the node; uneven places have more.
      if (amid(cloud, node)) CHECK(negative < (jitter == 0 ? 0.4 : 1));
    }
  }
}

TEST_CASE("the error of a node's value is of third order in the spacing") {
  const Wall wall{0.4};
  const auto error = [&](double s) {
    const Cloud cloud = beside_wall(wall, s, 23);
    const BoundaryFits fits = fits_of(cloud);
    const auto field = [](Vec2 at) {
      return std::sin(2 * at.x + at.y) + std::cos(at.x - 2 * at.y);
    };
    const std::vector<double> f = values(cloud, field);
    double sum = 0;
    int count = 0;
    for (const BoundaryFits::Node& node : fits.nodes()) {
      if (!amid(cloud, node)) continue;
      const auto i = static_cast<std::size_t>(node.particle);
      const Vec2 at = cloud.at(i);
      const double c = std::cos(2 * at.x + at.y), z = -std::sin(at.x - 2 * at.y);
      const double slope = dot(wall.normal(), {2 * c + z, c - 2 * z});
      sum += std::pow(fitted(node, f, slope) - f[i], 2), ++count;
    }
    return std::sqrt(sum / count);
  };
  CHECK(std::log2(error(0.1) / error(0.05)) > 2.6);
  CHECK(std::log2(error(0.05) / error(0.025)) > 2.6);
}

TEST_CASE("with too few neighbors a node's value is exact on fields linear along the wall") {
  const Cloud cloud = few({{-1, 1}, {0.1, 0.9}, {1, 1.1}, {-0.5, 1.8}, {0.6, 1.7}});
  const BoundaryFits fits = fits_of(cloud);
  const auto linear = [](Vec2 at) { return 2 + 3 * at.x - 4 * at.y; };
  CHECK(fitted(fits.of(0), values(cloud, linear), -4) == Approx(2).epsilon(1e-14));
}

TEST_CASE("three neighbors or one give a mean that knows the slope, and none nothing") {
  for (const auto& particles : {std::initializer_list<Vec2>{{-1, 1}, {0.1, 0.9}, {1, 1.1}},
                                std::initializer_list<Vec2>{{0.3, 0.5}}}) {
    const Cloud cloud = few(particles);
    const BoundaryFits fits = fits_of(cloud);
    CHECK(fits.of(0).neighbors.size() == particles.size());
    const auto rising = [](Vec2 at) { return 2 - 4 * at.y; };
    CHECK(fitted(fits.of(0), values(cloud, rising), -4) == Approx(2).epsilon(1e-14));
  }
  const Cloud nobody = few({});
  const BoundaryFits fits = fits_of(nobody);
  CHECK(fits.of(0).neighbors.empty());
  CHECK(fits.of(0).lever == 0);
}

TEST_CASE("particles in a line above a node are told apart by no slope along the wall") {
  const Cloud cloud = few({{0, 0.5}, {0, 1}, {0, 1.5}, {0, 2}, {0, 2.5}});
  const BoundaryFits fits = fits_of(cloud);
  double sum = 0;
  for (const auto& [j, weight] : fits.of(0).neighbors) sum += weight;
  CHECK(sum == Approx(1).epsilon(1e-14));
}

TEST_CASE("a node in a corner that lacks particles does not go by differences of neighbors") {
  // All on one side, two of them near: a slope along the wall would hang on these two.
  const Cloud cloud = few({{1, 0.75}, {1.19, 1.52}, {0.74, 2.3}, {1.82, 2.08}, {2.24, 1.34}});
  const BoundaryFits fits = fits_of(cloud);
  double sum = 0, sizes = 0;
  for (const auto& [j, weight] : fits.of(0).neighbors) sum += weight, sizes += std::abs(weight);
  CHECK(sum == Approx(1).epsilon(1e-13));
  CHECK(sizes < 4);
}
