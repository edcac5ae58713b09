#include "sph/adapt/wanted_spacing.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"

using namespace vortree;
using namespace vortree::sph;

TEST_CASE("the wanted spacing is that of a level at its distance, and linear between") {
  const std::shared_ptr<const body::Shape> circle = body::circle({}, 0.5);
  const double s = 0.05, zone = 0.3, growth = 1.5;
  const WantedSpacing wanted(circle, s, 4, zone, growth);
  CHECK(wanted.finest() == s);
  CHECK(wanted.coarsest() == 8 * s);
  const auto away = [&](double d) { return wanted.at({(0.5 + d) * 0.6, (0.5 + d) * 0.8}); };
  CHECK(away(0) == s);
  CHECK(away(zone) == Approx(s).epsilon(1e-12));
  double w = zone, before = zone, spacing = s;
  for (int level = 1; level < 4; ++level) {
    const double wider = growth * w + 2 * 2 * spacing,
                 d = std::max((w + wider) / 2, before + 4 * spacing);
    CHECK(away(d) == Approx(2 * spacing).epsilon(1e-12));
    CHECK(away(before + 0.25 * (d - before)) == Approx(1.25 * spacing).epsilon(1e-12));
    w = wider, before = d, spacing *= 2;
  }
  CHECK(away(before + 0.1) == 8 * s);
  CHECK(away(100) == 8 * s);
}

TEST_CASE("the wanted spacing is continuous, and nowhere steeper than two in a reach") {
  const std::shared_ptr<const body::Shape> ellipse = body::ellipse({}, 0.5, 0.1, 0.3);
  const double s = 0.02;
  const WantedSpacing wanted(ellipse, s, 5, 0.1, 2);
  // From level to level s_k in d_{k+1} - d_k, which is least between the first two:
  // (w_1 - w_0)/2 + (w_1 - w_0)/2 = ..., w_1 = 2 w_0 + 4 s_0, d_1 - d_0 = (w_0 + 4 s_0)/2.
  const double steepest = s / ((0.1 + 4 * s) / 2), step = 1e-3;
  double before = wanted.at({-3, 0.05});
  for (double x = -3 + step; x < 3; x += step) {
    const double now = wanted.at({x, 0.05});
    REQUIRE(std::abs(now - before) <= steepest * step * (1 + 1e-9));
    before = now;
  }
}

TEST_CASE("however narrow the zone and small the growth, spacing widens by a quarter of the way") {
  for (const double growth : {1.0, 1.2, 2.0})
    for (const double zone : {0.0, 0.05}) {
      const Widening widening(0.02, 0.32, zone, growth);  // four times two
      CHECK(widening.at(zone + 0.04) <= 0.03 * (1 + 1e-12));
      CHECK(widening.end() >= zone + 4 * (0.32 - 0.02) * (1 - 1e-12));
      for (double d = 0; d < 2; d += 0.01)
        REQUIRE(widening.at(d + 0.01) - widening.at(d) <= 0.25 * 0.01 * (1 + 1e-9));
    }
}

TEST_CASE("one level, and no body, want the coarsest spacing everywhere") {
  const std::shared_ptr<const body::Shape> circle = body::circle({}, 0.5);
  for (const double x : {0.0, 0.6, 5.0}) {
    CHECK(WantedSpacing(circle, 0.1, 1, 0.5, 2).at({x, 0}) == 0.1);
    CHECK(WantedSpacing(nullptr, 0.1, 3, 0.5, 2).at({x, 0}) == 0.4);
  }
}

TEST_CASE("within an ellipse particles are as fine as it asks for, and wider from there on") {
  WantedSpacing wanted(nullptr, 0.1, 2, 0, 2);
  wanted.add_ellipse({1, 2}, {0.5, 0.1}, std::numbers::pi / 6, 0.05);
  CHECK(wanted.finest() == 0.05);
  CHECK(wanted.coarsest() == 0.2);
  const Vec2 along{std::sqrt(0.75), 0.5}, across{-0.5, std::sqrt(0.75)}, middle{1, 2};
  for (const double inside : {-0.99, 0.0, 0.5, 0.99}) {
    CHECK(wanted.at(middle + 0.5 * inside * along) == 0.05);
    CHECK(wanted.at(middle + 0.1 * inside * across) == 0.05);
  }
  // From 0 to d_1 = 4 s_0 it doubles, to d_2 = 4 s_0 + 8 s_0 once more.
  CHECK(wanted.at(middle + (0.5 + 0.1) * along) == Approx(0.075).epsilon(1e-6));
  CHECK(wanted.at(middle + (0.1 + 0.2) * across) == Approx(0.1).epsilon(1e-6));
  CHECK(wanted.at(middle + (0.1 + 0.4) * across) == Approx(0.15).epsilon(1e-6));
  CHECK(wanted.at(middle + (0.1 + 0.7) * across) == 0.2);
}

TEST_CASE("the finest of several wishes counts, none steeper than a quarter") {
  const std::shared_ptr<const body::Shape> circle = body::circle({}, 0.5);
  WantedSpacing wanted(circle, 0.02, 5, 0.1, 2);
  const WantedSpacing beside_body = wanted;
  wanted.add_ellipse({1.5, 0}, {0.6, 0.2}, 0.3, 0.03);
  wanted.add_ellipse({1.9, 0}, {0.1, 0.1}, 0, 0.01);
  CHECK(wanted.at({1.9, 0}) == 0.01);
  CHECK(wanted.at({1.4, 0}) == 0.03);
  CHECK(wanted.at({0.55, 0}) == 0.02);
  const double step = 1e-3;
  double before = wanted.at({-3, 0.05});
  for (double x = -3 + step; x < 4; x += step) {
    const double now = wanted.at({x, 0.05});
    REQUIRE(now <= beside_body.at({x, 0.05}));
    REQUIRE(std::abs(now - before) <= 0.25 * step * (1 + 1e-9));
    before = now;
  }
}

TEST_CASE("a region of a periodic domain is there again after each period") {
  WantedSpacing wanted(nullptr, 0.1, 1, 0, 2, 1);
  wanted.add_ellipse({0.05, 0.5}, {0.1, 0.1}, 0, 0.05);
  for (const double x : {0.0, 0.96, 1.0, 0.1}) CHECK(wanted.at({x, 0.5}) == 0.05);
  CHECK(wanted.at({0.9, 0.5}) == Approx(wanted.at({0.2, 0.5})).epsilon(1e-12));
  CHECK(wanted.at({0.5, 0.5}) == 0.1);
}
