#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "body/extent.hpp"
#include "body/shapes/joukowski.hpp"
#include "body/shapes/naca4.hpp"
#include "body/shapes/plate.hpp"
#include "body/shapes/polygon.hpp"
#include "some_bodies.hpp"

using namespace vortree;
using namespace vortree::test;
using body::BodySettings;
using std::numbers::pi;

namespace {

BodySettings naca4(const std::string& digits) {
  return {.shape = &shape_kind("naca4"), .numbers = {{"chord", 1}}, .digits = digits};
}

std::string refusal(const BodySettings& body) {
  try {
    refuse(body);
  } catch (const Refused& refused) {
    return refused.what();
  }
  return "";
}

double area(const body::Shape& shape) {
  double twice = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec2 a = shape.point(shape.perimeter() * i / 20'000),
               b = shape.point(shape.perimeter() * (i + 1) / 20'000);
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

}  // namespace

namespace {

/// Half of a bend of radius 1 in many straight steps: its end, as seen from the middle along the
/// direction there and square to it.
Vec2 half_of_bend(double turns) {
  const int n = 200'000;
  double angle = 0;
  Vec2 at{};
  for (int i = 0; i < n; ++i) {
    const double step = turns / n, s = (i + 0.5) * step, c = std::cos(pi * s / (2 * turns));
    angle += c * c * step / 2;
    at += step * Vec2{std::cos(angle), std::sin(angle)};
    angle += c * c * step / 2;
  }
  return at;
}

/// The largest change of the curvature from one of many places along a wall to the next.
double jump_of_curvature(const body::Shape& shape, int places) {
  double worst = 0, before = shape.nearest(shape.point(0)).curvature;
  for (int i = 1; i <= places; ++i) {
    const double here = shape.nearest(shape.point(shape.perimeter() * i / places)).curvature;
    worst = std::max(worst, std::abs(here - before));
    before = here;
  }
  return worst;
}

}  // namespace

TEST_CASE("a plate is two lines and two round ends, whose curvature has no jumps") {
  const double length = 2, thickness = 0.1, turn = 0.4;
  const Vec2 half = half_of_bend(pi);
  const double radius = thickness / (2 * half.x);
  CHECK(radius == Approx(0.410 * thickness).epsilon(2e-3));
  const auto plate = body::plate({1, 3}, length, thickness, turn);
  CHECK(plate->perimeter() ==
        Approx(2 * (length - 2 * radius * half.y) + 4 * pi * radius).epsilon(1e-9));
  const auto there = [&](double x, double y) {
    return Vec2{1 + x * std::cos(turn) + y * std::sin(turn),
                3 - x * std::sin(turn) + y * std::cos(turn)};
  };
  for (const double x : {-0.85, -0.4, 0.0, 0.3, 0.85})
    for (const double y : {-0.3, -0.049, 0.02, 0.2})
      CHECK(plate->distance(there(x, y)) == Approx(std::abs(y) - thickness / 2).margin(1e-15));
  for (const double x : {-1.5, -0.99, 0.99, 1.2})
    CHECK(plate->distance(there(x, 0)) == Approx(std::abs(x) - length / 2).margin(1e-15));
  CHECK(plate->nearest(there(1.1, 0)).curvature == Approx(1 / radius).epsilon(1e-8));
  // Curvature rises to 1/radius within 2 pi radii: by its slope of pi/(2 pi) of that a radius.
  const int places = 20'000;
  const double spacing = plate->perimeter() / places;
  CHECK(jump_of_curvature(*plate, places) < 0.6 * spacing / (radius * radius));

  const BodySettings body{.shape = &shape_kind("plate"),
                          .numbers = {{"length", 2}, {"thickness", 0.1}}};
  CHECK(length_of(body) == 2);
  CHECK(tip_of(body).radius == Approx(radius).epsilon(1e-8));
  CHECK(std::abs(tip_of(body).place.x) == Approx(1).epsilon(1e-14));
  CHECK(refusal({.shape = &shape_kind("plate"), .numbers = {{"length", 1}, {"thickness", 0.6}}}) ==
        "body.thickness is 0.6; less than half of body.length = 1 was expected");
  CHECK_THROWS_AS(body::plate({}, 1, 0.5, 0), std::invalid_argument);
}

TEST_CASE("a polygon has lines and round corners, whose curvature has no jumps") {
  const double radius = 0.5, corner = 0.04;
  for (const int sides : {3, 4, 5, 8}) {
    const double turns = 2 * pi / sides, side = 2 * radius * std::sin(pi / sides);
    const auto polygon = body::polygon({}, sides, radius, corner, 0);
    // A corner takes from each of its two lines what it reaches along its own direction.
    const Vec2 half = half_of_bend(turns);
    const double taken = corner * half.x / std::cos(pi / sides);
    CHECK(polygon->perimeter() ==
          Approx(sides * (side - 2 * taken + 2 * turns * corner)).epsilon(1e-9));
    // The side that faces -x.
    CHECK(polygon->distance({-radius, 0}) ==
          Approx(radius * (1 - std::cos(pi / sides))).epsilon(1e-13));
    CHECK(polygon->nearest({-radius, 0}).curvature == Approx(0).margin(1e-12));
    CHECK(area(*polygon) < sides * side * radius * std::cos(pi / sides) / 2);
    const double slope = pi / (2 * turns * corner * corner);
    CHECK(jump_of_curvature(*polygon, 20'000) < 1.2 * slope * polygon->perimeter() / 20'000);
  }
  const BodySettings square{.shape = &shape_kind("polygon"),
                            .numbers = {{"sides", 4}, {"radius", std::sqrt(2)}, {"corner", 0.1}}};
  CHECK(length_of(square) == 2 * std::sqrt(2));
  CHECK(half_extent(square)[0] == Approx(1).epsilon(1e-13));
  CHECK(tip_of(square).radius == Approx(0.1).epsilon(1e-12));
  const Vec2 half = half_of_bend(pi / 2);
  CHECK(std::hypot(tip_of(square).place.x, tip_of(square).place.y) ==
        Approx(std::sqrt(2) - 0.1 * (half.x - half.y)).epsilon(1e-9));
  BodySettings bad = square;
  bad.numbers["sides"] = 4.5;
  CHECK(refusal(bad) == "body.sides is 4.5; a whole number was expected");
  bad = square;
  bad.numbers["corner"] = 1.2;
  CHECK(refusal(bad).starts_with("body.corner is 1.2; less than 0."));
  CHECK(refusal(bad).ends_with(" was expected, with which nothing is left of the sides"));
  CHECK_THROWS_AS(body::polygon({}, 2, 1, 0.1, 0), std::invalid_argument);
}

TEST_CASE("naca0012 is naca4 of 0012") {
  const auto word = outline_of(foil(1, 10));
  BodySettings digits = naca4("0012");
  digits.incidence = 10;
  const auto same = outline_of(digits);
  CHECK(word->perimeter() == same->perimeter());
  for (double arc = 0; arc < 2; arc += 0.01) {
    CHECK(word->point(arc).x == same->point(arc).x);
    CHECK(word->point(arc).y == same->point(arc).y);
  }
}

TEST_CASE("a section of four digits stands square upon its mean line") {
  const double m = 0.04, p = 0.3, t = 0.15, edge = 0.002;
  const auto shape = body::naca4({0.5, 0}, "4315", 1, edge, 0);
  for (const double x : {0.01, 0.1, 0.25, 0.35, 0.6, 0.9, 0.99}) {
    const double half = (5 * t *
                             (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x +
                              0.2843 * std::pow(x, 3) - 0.1036 * std::pow(x, 4)) +
                         edge * std::pow(x, 4)) *
                        std::sqrt((1 - x) / (1 - x + edge / 2));
    const double front = m / (p * p), back = m / ((1 - p) * (1 - p));
    const double mean =
        x < p ? front * (2 * p * x - x * x) : back * (1 - 2 * p + 2 * p * x - x * x);
    const double theta = std::atan(2 * (x < p ? front : back) * (p - x));
    for (const double side : {1.0, -1.0})
      CHECK(std::abs(shape->distance({x - side * half * std::sin(theta),
                                      mean + side * half * std::cos(theta)})) < 1e-15);
  }
  const double slope = -2 * m * 0.7 / (0.7 * 0.7);
  const Vec2 tail = unit(Vec2{1, slope});
  CHECK(1 / shape->nearest(Vec2{1, 0} + 0.1 * tail).curvature ==
        Approx(edge * tail.x).epsilon(1e-9));
}

TEST_CASE("digits that are no section are refused, with what was expected") {
  CHECK(refusal(naca4("2412")).empty());
  CHECK(refusal(naca4("0001")).empty());
  for (const std::string digits : {"", "241", "24120", "24a2", "23012", "-412"})
    CHECK(refusal(naca4(digits)) ==
          "body.digits is \"" + digits + "\"; four digits were expected, as \"2412\"");
  CHECK(refusal(naca4("2400")) ==
        "body.digits is \"2400\"; the last two are its thickness; 01 .. 99 was expected");
  CHECK(refusal(naca4("2012")) ==
        "body.digits is \"2012\"; it has camber; the second digit, where that is, must be 1 .. 9");
  CHECK(refusal(naca4("9140")) ==
        "body.digits is \"9140\"; so much camber so near to an end folds the outline of so thick a "
        "section; less of one of them was expected");
  CHECK_THROWS_AS(body::naca4({}, "12", 1, 0.005, 0), std::invalid_argument);
}

TEST_CASE("a section of Joukowski is what its map makes of a circle") {
  using Complex = std::complex<double>;
  const double e = 0.09, g = 0.03, chord = 2;
  const auto mapped = [&](double h, double t) {
    const Complex middle{-e, h}, zeta = middle + (std::abs(1.0 - middle) + g) * std::polar(1.0, t);
    return zeta + 1.0 / zeta;
  };
  // What it is called by, of the section without camber: by samples of it.
  const int n = 100'000;
  double left = 0, right = 0, top = 0;
  for (int i = 0; i < n; ++i) {
    const Complex z = mapped(0, 2 * pi * i / n);
    left = std::min(left, z.real()), right = std::max(right, z.real());
    top = std::max(top, z.imag());
  }
  const double step = 1e-3;
  const Complex tip = mapped(0, 0), beside = mapped(0, step);
  const double radius = beside.imag() * beside.imag() / (2 * (tip - beside).real());
  for (const double h : {0.0, 0.1}) {
    double low = 0, high = 0;
    for (int i = 0; i < n; ++i) {
      const double x = mapped(h, 2 * pi * i / n).real();
      low = std::min(low, x), high = std::max(high, x);
    }
    const auto shape = body::joukowski({}, chord, chord * 2 * top / (right - left), chord * h / 2,
                                       radius / (right - left), 0);
    double worst = 0;
    for (int i = 0; i < 400; ++i) {
      const Complex z = chord / (high - low) * (mapped(h, 2 * pi * i / 400) - (low + high) / 2);
      worst = std::max(worst, std::abs(shape->distance({z.real(), z.imag()})));
    }
    // The radius by a chord of 1e-3 is right to 1e-4 of it: so of g, and the tip.
    CHECK(worst < 1e-5);
    CHECK(shape->perimeter() > 2 * chord);
  }
  const double least = body::thinnest_joukowski(0.002);
  CHECK(least == Approx(2 * std::sqrt(0.002 / 2)).epsilon(0.05));
  CHECK(refusal(
            {.shape = &shape_kind("joukowski"), .numbers = {{"chord", 1}, {"thickness", 0.03}}}) ==
        "body.thickness is 0.03; 0.06325 .. 0.5 was expected, with such a chord and edge");
  CHECK(refusal({.shape = &shape_kind("joukowski"),
                 .numbers = {{"chord", 1}, {"thickness", 0.1}, {"camber", 0.3}}}) ==
        "body.camber is 0.3; 0 .. 0.25 was expected, with such a chord");
}
