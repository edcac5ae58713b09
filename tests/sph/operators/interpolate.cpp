#include "sph/operators/interpolate.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "sph/operators/clouds.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

Vec2 stream(Vec2 at) {
  return {std::sin(2 * at.x) * std::cos(3 * at.y), std::cos(3 * at.x + at.y)};
}
double curl(Vec2 at) {
  return -3 * std::sin(3 * at.x + at.y) + 3 * std::sin(2 * at.x) * std::sin(3 * at.y);
}

struct Flow {
  Cloud cloud;
  std::vector<Slopes> slopes;
  std::vector<std::uint32_t> all;
};

Flow flow(Cloud cloud, const auto& velocity) {
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec2 u = velocity(cloud.at(i));
    cloud.u[i] = u.x, cloud.v[i] = u.y;
    cloud.p[i] = u.x - 2 * u.y;
  }
  Stencils stencils;
  stencils.renew(cloud, {});
  Flow made{std::move(cloud), {}, {}};
  find_slopes(made.cloud, stencils, made.slopes);
  made.all.resize(made.cloud.size());
  std::iota(made.all.begin(), made.all.end(), 0u);
  return made;
}

/// Places at random well within the unit square.
struct Places {
  std::vector<double> x, y;
  explicit Places(int n, double low = 0.2, double high = 0.8) {
    Chance chance(4);
    for (int k = 0; k < n; ++k) {
      x.push_back(low + (high - low) * chance.real());
      y.push_back(low + (high - low) * chance.real());
    }
  }
  Vec2 at(std::size_t k) const { return {x[k], y[k]}; }
};

}  // namespace

TEST_CASE("between particles, quadratic velocities and pressure and linear vorticity are exact") {
  Chance chance(2);
  const Polynomial p(2, chance), q(2, chance);
  const Flow of = flow(uneven_cloud(16, 31), [&](Vec2 at) { return Vec2{p(at), q(at)}; });
  const Places places(200);
  const Interpolated found = interpolate(of.cloud, of.slopes, of.all, {places.x, places.y});
  for (std::size_t k = 0; k < 200; ++k) {
    REQUIRE(found.covered[k]);
    const Vec2 at = places.at(k);
    // Slopes by fits of condition below 100, whose square is lost, times some 30 roundings.
    CHECK(found.u[k] == Approx(p(at)).margin(1e-10));
    CHECK(found.v[k] == Approx(q(at)).margin(1e-10));
    CHECK(found.omega[k] == Approx(q.slopes(at).x - p.slopes(at).y).margin(1e-9));
    CHECK(found.p[k] == Approx(p(at) - 2 * q(at)).margin(3e-10));
  }
}

TEST_CASE("between particles velocities err by the third order, the vorticity by the second") {
  const auto errors = [](int n) {
    const Flow of = flow(uneven_cloud(n, 32, 0.15), stream);
    const Places places(400);
    const Interpolated found = interpolate(of.cloud, of.slopes, of.all, {places.x, places.y});
    double u = 0, omega = 0;
    for (std::size_t k = 0; k < 400; ++k) {
      const Vec2 exact = stream(places.at(k));
      u += std::pow(found.u[k] - exact.x, 2) + std::pow(found.v[k] - exact.y, 2);
      omega += std::pow(found.omega[k] - curl(places.at(k)), 2);
    }
    return std::pair{std::sqrt(u / 400), std::sqrt(omega / 400)};
  };
  const auto [u, omega] = errors(16);
  const auto [finer_u, finer_omega] = errors(32);
  CHECK(std::log2(u / finer_u) > 2.6);
  CHECK(std::log2(omega / finer_omega) > 1.7);
  CHECK(finer_u < 1e-4);
}

TEST_CASE("a place is covered where a chosen particle is nearer than 1.5 spacings") {
  const Flow of = flow(uneven_cloud(12, 33), stream);
  std::vector<std::uint32_t> some;
  for (const std::uint32_t i : of.all)
    if (of.cloud.x[i] < 0.4 || of.cloud.y[i] > 0.8) some.push_back(i);
  const Places places(600, -0.3, 1.3);
  const Interpolated found = interpolate(of.cloud, of.slopes, some, {places.x, places.y});
  int covered = 0;
  for (std::size_t k = 0; k < 600; ++k) {
    const bool near = std::ranges::any_of(some, [&](std::uint32_t i) {
      const Vec2 d = places.at(k) - of.cloud.at(i);
      return std::hypot(d.x, d.y) < 1.5 * of.cloud.spacing[i];
    });
    REQUIRE(static_cast<bool>(found.covered[k]) == near);
    covered += near;
    if (near) continue;
    CHECK(found.u[k] == 0);
    CHECK(found.v[k] == 0);
    CHECK(found.omega[k] == 0);
    CHECK(found.p[k] == 0);
  }
  CHECK(covered > 100);
  CHECK(covered < 500);
}

TEST_CASE("interpolation knows no place and no particle, too") {
  const Flow of = flow(uneven_cloud(6, 34), stream);
  CHECK(interpolate(of.cloud, of.slopes, of.all, {}).u.empty());
  const std::vector<double> half{0.5};
  const Interpolated found = interpolate(of.cloud, of.slopes, {}, {half, half});
  CHECK(found.u == std::vector<double>{0});
  CHECK_FALSE(found.covered[0]);
}
