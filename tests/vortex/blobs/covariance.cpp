#include "vortex/blobs/covariance.hpp"

#include <catch2/catch.hpp>

#include "vortex/strained_flows.hpp"

using namespace vortree;
using vortex::Core;
using vortex::Covariance;
using vortex::Gradient;

namespace {

// Strain, rotation and shear of every kind, and what lies between a rotation and a strain.
const Gradient gradients[] = {{0, 0, 0},        {0.7, 0, 0},       {0, 1.3, 0},
                              {0, 0, -0.9},     {0, 1, -1},        {0.5, -2, 0.3},
                              {1, 1, -1},       {1, 1, -1 + 1e-9}, {1, 1, -1.001},
                              {0.3, 0.8, -2.5}, {-2, 0.1, 0.1},    {1e-9, 1e-9, -1e-9}};
const Core cores[] = {{1, {}}, {2, {0.3, -0.8}}, {1e-4, {-4e-5, 1e-5}}, {0.5, {0.25, 0}}};

/// Where a point goes in the flow u = G x: Runge-Kutta's classical method.
Vec2 along(const Gradient& g, double dt, Vec2 x) {
  const auto u = [&](Vec2 a) { return Vec2{g.ux * a.x + g.uy * a.y, g.vx * a.x - g.ux * a.y}; };
  constexpr int steps = 400;
  const double h = dt / steps;
  for (int k = 0; k < steps; ++k) {
    const Vec2 a = u(x), b = u(x + (h / 2) * a), c = u(x + (h / 2) * b), d = u(x + h * c);
    x = x + (h / 6) * (a + 2 * b + 2 * c + d);
  }
  return x;
}

Covariance plain(const Core& core) {
  return core.covariance({1, 0});
}

/// Four points have any covariance: two pairs around the centre, here carried by the flow.
Covariance of_carried_points(const Core& core, const Gradient& g, double dt) {
  const auto [xx, xy, yy] = plain(core);
  const double a = std::sqrt(2 * xx);
  const Vec2 points[] = {{a, 2 * xy / a}, {0, std::sqrt(std::max(2 * (yy - xy * xy / xx), 0.0))}};
  Covariance sum{};
  for (const Vec2& point : points) {
    const Vec2 at = along(g, dt, point);
    sum.nn += at.x * at.x / 2;
    sum.nt += at.x * at.y / 2;
    sum.tt += at.y * at.y / 2;
  }
  return sum;
}

double determinant(const Core& core) {
  const auto [xx, xy, yy] = plain(core);
  return xx * yy - xy * xy;
}

}  // namespace

TEST_CASE("a carried core has the covariance of points that the linear flow carries") {
  for (const Gradient& g : gradients)
    for (const Core& core : cores)
      for (double dt : {0.0, 1e-3, 0.3, 1.5}) {
        CAPTURE(g.ux, g.uy, g.vx, core.square, dt);
        const Covariance v = plain(carried(core, g, dt));
        CHECK(test::difference(v, of_carried_points(core, g, dt)) < 1e-8 * (v.nn + v.tt));
      }
}

TEST_CASE("a carried core keeps its area: the determinant of its covariance stays") {
  for (const Gradient& g : gradients)
    for (const Core& core : cores) {
      const Core later = carried(core, g, 0.8);
      CHECK(std::abs(determinant(later) - determinant(core)) < 1e-14 * later.square * later.square);
    }
}

TEST_CASE(
    "cores are carried by a group: two times in turn are their sum, and the way back undoes") {
  for (const Gradient& g : gradients)
    for (const Core& core : cores) {
      const Core at_once = carried(core, g, 1.1), in_turn = carried(carried(core, g, 0.4), g, 0.7);
      CHECK(test::difference(plain(at_once), plain(in_turn)) < 1e-14 * at_once.square);
      const Core back = carried(at_once, {-g.ux, -g.uy, -g.vx}, 1.1);
      CHECK(test::difference(plain(back), plain(core)) <
            1e-12 * at_once.square * at_once.square / core.square);
    }
}

TEST_CASE("a core is the same in every frame, and `widest` is its sigma where it is widest") {
  for (const Core& core : cores) {
    double widest = 0;
    for (int k = 0; k < 720; ++k) {
      const double phi = k * std::numbers::pi / 720;
      const Vec2 n{std::cos(phi), std::sin(phi)};
      const Covariance v = core.covariance(n);
      const Core again = core_of(v, n);
      CHECK(again.square == Approx(core.square).epsilon(1e-15));
      CHECK((again.deviator - core.deviator).size() < 1e-15 * core.square);
      const auto [xx, xy, yy] = plain(core);
      CHECK(
          v.nn ==
          Approx(n.x * n.x * xx + 2 * n.x * n.y * xy + n.y * n.y * yy).margin(1e-15 * core.square));
      widest = std::max(widest, std::sqrt(2 * v.nn));
    }
    CHECK(vortex::widest(core) >= widest * (1 - 1e-15));
    CHECK(vortex::widest(core) == Approx(widest).epsilon(1e-5));
  }
}
