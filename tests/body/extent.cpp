#include "body/extent.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "some_bodies.hpp"

using namespace vortree;
using namespace vortree::test;
using body::BodySettings;
using std::numbers::pi;

namespace {

double size(Vec2 a) {
  return std::hypot(a.x, a.y);
}

/// Of an ellipse, by the complete elliptic integral of the second kind.
double exact_perimeter(double a, double b) {
  return 4 * std::max(a, b) *
         std::comp_ellint_2(std::sqrt(1 - std::pow(std::min(a, b) / std::max(a, b), 2)));
}

}  // namespace

TEST_CASE("coefficients go by twice the radius, or the chord") {
  CHECK(length_of(circle(0.3)) == 0.6);
  CHECK(length_of(ellipse(0.5, 2, 30)) == 1);
  CHECK(length_of(foil(3, 10)) == 3);
}

TEST_CASE(
    "perimeters are those of circles and ellipses, and of a foil a little more than two chords") {
  CHECK(perimeter_of(circle(0.3)) == 2 * pi * 0.3);
  for (const double across : {1e-2, 0.1, 0.5, 0.7, 20.0})
    CHECK(perimeter_of(ellipse(0.5, across, 17)) ==
          Approx(exact_perimeter(0.5, across)).epsilon(1e-10));
  // The polygon through the 18 places of the section's table in Abbott & von Doenhoff has 2.040.
  CHECK(perimeter_of(foil(1)) == Approx(2.04).epsilon(2e-3));
  CHECK(perimeter_of(foil(3, 5)) == Approx(3 * perimeter_of(foil(1))).epsilon(1e-12));
}

TEST_CASE("the tip is the sharpest end: R of a circle, b^2/a of an ellipse, the edge of a foil") {
  CHECK(tip_of(circle(0.3)).radius == Approx(0.3).epsilon(1e-14));
  CHECK(size(tip_of(circle(0.3)).place) == Approx(0.3).epsilon(1e-14));
  const double turn = 20 * pi / 180;
  for (const double across : {0.004, 0.1, 0.49}) {
    const auto [place, radius] = tip_of(ellipse(0.5, across, 20));
    CHECK(radius == Approx(across * across / 0.5).epsilon(1e-12));
    CHECK(std::abs(place.x) == Approx(0.5 * std::cos(turn)).epsilon(1e-12));
    CHECK(place.y / place.x == Approx(-std::tan(turn)).epsilon(1e-12));
  }
  const auto upright = tip_of(ellipse(0.5, 2));
  CHECK(upright.radius == Approx(0.5 * 0.5 / 2).epsilon(1e-12));
  CHECK(std::abs(upright.place.y) == Approx(2));
  BodySettings section = foil(2, 20);
  for (const double edge : {1e-4, 0.005, 0.01}) {
    section.numbers["edge"] = edge;
    const auto [place, radius] = tip_of(section);
    CHECK(radius == Approx(2 * edge).epsilon(1e-9));
    CHECK(place.x == Approx(std::cos(turn)).epsilon(1e-12));
    CHECK(place.y == Approx(-std::sin(turn)).epsilon(1e-12));
  }
}

TEST_CASE("a circle is round, by whatever shape; nothing else is") {
  CHECK(round(circle(1e-3)));
  CHECK(round(ellipse(0.5, 0.5, 3)));
  CHECK_FALSE(round(ellipse(0.5, 0.4999)));
  CHECK_FALSE(round(foil(1)));
}

TEST_CASE("a body fills the rectangle of its half extent, and no more of it") {
  BodySettings away = circle(0.3);
  away.centre = {5, 7};
  CHECK(half_extent(away) == std::array{0.3, 0.3});
  for (const double degrees : {0.0, 20.0, 45.0, -70.0, 90.0, 180.0}) {
    const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
    const auto [x, y] = half_extent(ellipse(0.5, 0.1, degrees));
    CHECK(x == Approx(std::hypot(0.5 * c, 0.1 * s)).epsilon(1e-7));
    CHECK(y == Approx(std::hypot(0.5 * s, 0.1 * c)).epsilon(1e-7));
  }
  const auto [along, across] = half_extent(foil(2));
  CHECK(along == Approx(1).epsilon(1e-12));
  CHECK(across == Approx(0.06 * 2).epsilon(3e-3));  // 12 % thick
  for (const double degrees : {3.0, -50.0}) {
    const auto section = outline_of(foil(1, degrees));
    const auto [x, y] = half_extent(foil(1, degrees));
    double right = 0, top = 0;
    for (int i = 0; i < 20'000; ++i) {
      const Vec2 at = section->point(section->perimeter() * i / 20'000);
      right = std::max(right, std::abs(at.x));
      top = std::max(top, std::abs(at.y));
    }
    CHECK(std::abs(x - right) < 1e-7);
    CHECK(std::abs(y - top) < 1e-7);
  }
}

TEST_CASE("a body covers what lies within its outline, where the scene has it") {
  BodySettings body = ellipse(0.5, 0.1, 20);
  body.centre = {3, 4};
  const double c = std::cos(20 * pi / 180), s = std::sin(20 * pi / 180);
  for (const double share : {0.0, 0.5, 0.999, 1.001, 2.0})
    for (const auto& [along, across] :
         {std::pair{0.5, 0.0}, std::pair{0.0, 0.1}, std::pair{0.3, 0.08}}) {
      const double x = share * along, y = share * across;
      CHECK(covers(body, {3 + c * x + s * y, 4 - s * x + c * y}) == (share < 1));
    }
  BodySettings round = circle(0.5);
  round.centre = {-1, 0};
  CHECK(covers(round, {-0.51, 0}));
  CHECK_FALSE(covers(round, {-0.49, 0}));
  CHECK(covers(foil(1), {0.45, 0}));
  CHECK_FALSE(covers(foil(1), {0.45, 0.02}));
  CHECK_FALSE(covers(foil(1), {0.501, 0}));
}
