#include "sph/adapt/wanted_spacing.hpp"

#include <catch2/catch.hpp>
#include <cmath>

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
    const double wider = growth * w + 2 * 2 * spacing, d = (w + wider) / 2;
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

TEST_CASE("one level, and no body, want the same spacing everywhere") {
  const std::shared_ptr<const body::Shape> circle = body::circle({}, 0.5);
  for (const WantedSpacing& wanted :
       {WantedSpacing(circle, 0.1, 1, 0.5, 2), WantedSpacing(nullptr, 0.1, 3, 0.5, 2)})
    for (const double x : {0.0, 0.6, 5.0}) CHECK(wanted.at({x, 0}) == 0.1);
}
