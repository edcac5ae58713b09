#include "body/shapes/shapes.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "body/extent.hpp"
#include "body/outlines/outline.hpp"
#include "some_bodies.hpp"

using namespace vortree;
using namespace vortree::test;
using body::BodySettings;

namespace {

// A shape that the program does not know: |x|^4 + |y|^4 = a^4, by the angle seen from its centre.

double side(const BodySettings& body) {
  return 2 * body.number("half");
}

/// r(t) = (cos^4 t + sin^4 t)^(-1/4) = (3/4 + cos(4 t)/4)^(-1/4), and its derivatives.
std::unique_ptr<body::Shape> draw_squircle(const BodySettings& body) {
  const double a = body.number("half");
  return body::outline([a, place = body::Placement({}, body.turn())](double t) {
    const double c = std::cos(t), s = std::sin(t);
    const double q = 0.75 + std::cos(4 * t) / 4, q1 = -std::sin(4 * t), q2 = -4 * std::cos(4 * t);
    const double r = std::pow(q, -0.25), r1 = -0.25 * r * q1 / q,
                 r2 = -0.25 * r * q2 / q + 0.3125 * r * q1 * q1 / (q * q);
    return place({a * Vec2{r * c, r * s}, a * Vec2{r1 * c - r * s, r1 * s + r * c},
                  a * Vec2{r2 * c - 2 * r1 * s - r * c, r2 * s + 2 * r1 * c - r * s}});
  });
}

const body::ShapeKind squircle{
    {"squircle", {{"half", positive, "L", "half its width", 0.5}}}, side, draw_squircle};

/// The key that is refused, and the words.
std::string refusal(const BodySettings& body) {
  try {
    refuse(body);
  } catch (const Refused& refused) {
    return refused.key + ": " + refused.what();
  }
  return "";
}

std::vector<std::string> names_of_keys(const std::vector<Key>& keys) {
  std::vector<std::string> names;
  for (const Key& key : keys) names.emplace_back(key.name);
  return names;
}

}  // namespace

TEST_CASE("a body has the keys of all shapes, and is a circle unless another is named") {
  BodySettings body;
  const std::vector<Key> all = keys(body);
  CHECK(names_of_keys(all) ==
        std::vector<std::string>{"shape", "radius", "across", "chord", "edge", "thickness",
                                 "camber", "length", "sides", "corner", "scale", "digits", "file",
                                 "points", "incidence", "centre", "panels", "motion"});
  CHECK(body == BodySettings{});
  const OneOf shape = std::get<OneOf>(all[0].target);
  CHECK(shape.words == std::vector<std::string_view>{"circle", "ellipse", "naca0012", "naca4",
                                                     "joukowski", "plate", "polygon", "points"});
  CHECK(body.shape == &shape_kind("circle"));
  shape.set(2);
  CHECK(body.shape == &shape_kind("naca0012"));
  *std::get<std::optional<double>*>(all[3].target) = 3;
  CHECK((body.number("chord") == 3 && body.number("edge") == 0.005));
  CHECK((all[4].rule.low == 1e-4 && all[4].rule.high == 0.02 && all[4].unit == "chord"));
  CHECK(all[1].says ==
        "circle, which needs it: its radius; ellipse, which needs it: half the long axis; polygon, "
        "which needs it: half its length: to the corners, before they are rounded");
}

TEST_CASE("a body has the numbers of its shape, and no others") {
  CHECK(refusal(circle(1)).empty());
  CHECK(refusal(ellipse(1, 2)).empty());
  CHECK(refusal(foil(1)).empty());
  CHECK(refusal(BodySettings{}) ==
        "body: body.shape is \"circle\"; that needs the key body.radius");
  CHECK(refusal({.shape = &shape_kind("ellipse"), .numbers = {{"radius", 1}}}) ==
        "body: body.shape is \"ellipse\"; that needs the key body.across");
  CHECK(refusal({.shape = &shape_kind("naca0012"), .numbers = {{"radius", 1}}}) ==
        "body.radius: body.shape is \"naca0012\"; that does not have the key body.radius");
  CHECK(refusal({.shape = &shape_kind("naca4"), .numbers = {{"chord", 1}}}) ==
        "body: body.shape is \"naca4\"; that needs the key body.digits");
  CHECK(refusal({.shape = &shape_kind("points")}) ==
        "body: body.shape is \"points\"; that needs the key body.file, or points");
  CHECK(refusal({.numbers = {{"radius", 1}}, .digits = "2412"}) ==
        "body.digits: body.shape is \"circle\"; that does not have the key body.digits");
  CHECK(refusal({.numbers = {{"radius", 1}}, .points = std::vector<double>{0, 0}}) ==
        "body.points: body.shape is \"circle\"; that does not have the key body.points");
  CHECK(refusal({.numbers = {{"radius", 1}, {"edge", 0.01}}}) ==
        "body.edge: body.shape is \"circle\"; that does not have the key body.edge");
}

TEST_CASE("a body is drawn about the origin, wherever it lies, by the numbers of its shape") {
  BodySettings body = ellipse(0.5, 0.1, 20);
  body.centre = {7, -3};
  const auto drawn = outline_of(body), known = body::ellipse({}, 0.5, 0.1, body.turn());
  CHECK(outline_of(circle(0.3))->perimeter() == body::circle({}, 0.3)->perimeter());
  const auto section = outline_of(foil(2)), same = body::naca0012({}, 2, 0.005, 0);
  for (double arc = 0; arc < 2; arc += 0.125) {
    CHECK(drawn->point(arc).x == known->point(arc).x);
    CHECK(drawn->point(arc).y == known->point(arc).y);
    CHECK(section->point(arc).y == same->point(arc).y);
  }
  CHECK_THROWS_AS(outline_of(circle(-1)), std::invalid_argument);
  CHECK_THROWS_AS(outline_of(BodySettings{}), std::invalid_argument);
}

TEST_CASE("a shape that is one object more has keys and refusals, is drawn and measured") {
  const std::array<const body::ShapeKind*, 2> list{&shape_kind("circle"), &squircle};
  const std::span<const body::ShapeKind* const> kinds(list);
  BodySettings body;
  const std::vector<Key> all = keys_of(as_kinds(kinds), "shape", "outline of the body",
                                       one_of(kinds, body.shape), body.numbers);
  CHECK(names_of_keys(all) == std::vector<std::string>{"shape", "radius", "half"});
  CHECK(all[2].says == "squircle: half its width, 0.5 if not written");
  std::get<OneOf>(all[0].target).set(1);
  CHECK(body.shape == &squircle);
  CHECK(refusal(body).empty());
  CHECK(length_of(body) == 1);
  *std::get<std::optional<double>*>(all[1].target) = 2;
  CHECK(refusal(body) ==
        "body.radius: body.shape is \"squircle\"; that does not have the key body.radius");

  body.numbers = {{"half", 2}};
  body.incidence = 45;
  body.centre = {10, 0};
  CHECK(refusal(body).empty());
  CHECK(length_of(body) == 4);
  // Corners lie at x = y = a 2^(-1/4): seen from the centre a 2^(1/4) away.
  const double corner = 2 * std::pow(2, 0.25);
  CHECK(half_extent(body)[0] == Approx(corner).epsilon(1e-9));
  CHECK(half_extent(body)[1] == Approx(corner).epsilon(1e-9));
  CHECK(covers(body, {10 + 0.999 * corner, 0}));
  CHECK_FALSE(covers(body, {10 + 1.001 * corner, 0}));
  // There y'' and y' of y = (a^4 - x^4)^(1/4) are -6 2^(1/4)/a and -1: the radius is
  // (1 + y'^2)^(3/2)/|y''|.
  const auto [place, radius] = tip_of(body);
  CHECK(std::hypot(place.x, place.y) == Approx(corner).epsilon(1e-12));
  CHECK(radius == Approx(2 * std::pow(2, 1.5) / (6 * std::pow(2, 0.25))).epsilon(1e-12));
  CHECK_FALSE(round(body));
  const BodySettings half{.shape = &squircle, .numbers = {{"half", 1}}};
  CHECK(perimeter_of(body) == Approx(2 * perimeter_of(half)));
}
