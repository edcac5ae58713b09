#include "body/shapes/points.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/extent.hpp"
#include "body/shapes/from_points/contour.hpp"
#include "some_bodies.hpp"

using namespace vortree;
using namespace vortree::test;
using body::BodySettings;
using Catch::Matchers::Contains;
using std::numbers::pi;

namespace {

using Coordinates = std::vector<double>;

BodySettings through(const Coordinates& points) {
  return {.shape = &shape_kind("points"), .points = points};
}

/// Of radius 1/2, anticlockwise or clockwise; unevenly, by a third from mean to densest.
Coordinates circle_of(int n, int way = 1) {
  Coordinates all;
  for (int i = 0; i < n; ++i) {
    const double even = way * 2 * pi * i / n, angle = even + 0.3 * std::sin(even);
    all.push_back(0.5 * std::cos(angle));
    all.push_back(0.5 * std::sin(angle));
  }
  return all;
}

double error_of_circle(int n) {
  double worst = 0;
  const auto shape = outline_of(through(circle_of(n)));
  for (const auto& one : shape->trace())
    worst = std::max(worst, std::abs(std::hypot(one.at.x, one.at.y) - 0.5));
  return worst;
}

/// NACA 0012 by 2 n + 1 points from its edge on, over the upper side and back; `last` is 0.1036 for
/// a sharp edge, 0.1015 for one that is 0.0025 thick.
Coordinates section_of(int n, double last) {
  Coordinates all;
  for (int i = 0; i <= 2 * n; ++i) {
    const double x = 0.5 * (1 + std::cos(pi * i / n));
    const double y = 0.6 * (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x +
                            0.2843 * std::pow(x, 3) - last * std::pow(x, 4));
    all.push_back(x);
    all.push_back(i <= n ? y : -y);
  }
  return all;
}

Coordinates backwards(const Coordinates& all) {
  Coordinates other;
  for (std::size_t i = all.size(); i > 0; i -= 2) {
    other.push_back(all[i - 2]);
    other.push_back(all[i - 1]);
  }
  return other;
}

std::string refusal(const BodySettings& body) {
  try {
    refuse(body);
  } catch (const Refused& refused) {
    return refused.what();
  }
  return "";
}
std::string refusal(const Coordinates& points) {
  return refusal(through(points));
}

}  // namespace

TEST_CASE("a circle through points is the circle to fourth order in their spacing") {
  double before = error_of_circle(50);
  for (const int n : {100, 200, 400}) {
    const double now = error_of_circle(n);
    CAPTURE(n, before, now);
    CHECK(before / now > 14);
    CHECK(before / now < 19);
    before = now;
  }
  CHECK(error_of_circle(200) < 4e-9);
  const BodySettings body = through(circle_of(200));
  CHECK(refusal(body).empty());
  CHECK(told_of(body).empty());
  CHECK(length_of(body) == Approx(1).epsilon(1e-4));
  CHECK(perimeter_of(body) == Approx(pi).epsilon(1e-8));
}

TEST_CASE("the curvature of a curve through points has no jumps") {
  // A cubic's second derivative is off by h^2/12 of the fourth, here h = 0.02: 1e-4 of 2. Its jumps
  // would be of that size where points meet if the slopes alone were continuous.
  const auto shape = outline_of(through(circle_of(200)));
  double worst = 0;
  const int n = 200'000;
  double before = shape->nearest(shape->point(0)).curvature;
  for (int i = 1; i <= n; ++i) {
    const double here = shape->nearest(shape->point(shape->perimeter() * i / n)).curvature;
    worst = std::max(worst, std::abs(here - before));
    before = here;
  }
  CHECK(worst < 1e-5);
}

TEST_CASE("points that run clockwise are taken the other way round, and that is told") {
  const BodySettings left = through(circle_of(60)), right = through(circle_of(60, -1));
  CHECK(told_of(right) == std::vector<std::string>{
                              "body.points: the outline runs clockwise, and is taken the other way "
                              "round"});
  const auto a = outline_of(left), b = outline_of(right);
  CHECK(a->perimeter() == Approx(b->perimeter()).epsilon(1e-14));
  for (const double angle : {0.1, 2.0, 5.0}) {
    const Vec2 at{std::cos(angle), std::sin(angle)};
    CHECK(a->distance(at) == Approx(b->distance({at.x, -at.y})).epsilon(1e-13));
  }
}

TEST_CASE("the first point may be there again as the last") {
  Coordinates closed = circle_of(60);
  closed.push_back(closed[0]);
  closed.push_back(closed[1]);
  const auto a = outline_of(through(circle_of(60))), b = outline_of(through(closed));
  for (double arc = 0; arc < 3; arc += 0.1) CHECK(a->point(arc).x == b->point(arc).x);
}

TEST_CASE("a trailing edge, sharp or open, is rounded behind the middle of the chord, and told") {
  for (const auto& [last, words] :
       {std::pair{0.1036, "sharp"}, std::pair{0.1015, "open by 0.00252 of the chord"}}) {
    for (const bool turned : {false, true}) {
      const Coordinates points = turned ? backwards(section_of(60, last)) : section_of(60, last);
      BodySettings body = through(points);
      CHECK(refusal(body).empty());
      const auto told = told_of(body);
      REQUIRE(told.size() == (turned ? 2 : 1));
      CHECK_THAT(told.back(), Contains(words) && Contains("rounded with a radius of 0.005 of it"));
      CHECK(length_of(body) == 1);
      const auto shape = outline_of(body);
      CHECK(shape->nearest({1, 0}).distance == Approx(0.5).epsilon(1e-9));
      CHECK(1 / shape->nearest({1, 0}).curvature == Approx(0.005).epsilon(0.01));
      CHECK(tip_of(body).radius == Approx(0.005).epsilon(0.01));
      // Before the middle it is the section itself, to the error of the spline; behind it as the
      // formula has it.
      for (const double x : {0.05, 0.2, 0.4, 0.49, 0.6, 0.8, 0.95, 0.99}) {
        const double w = x < 0.5 ? 0 : std::pow(2 * x - 1, 4), open = 0.6 * (0.1036 - last);
        double y = 0.6 * (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x +
                          0.2843 * std::pow(x, 3) - last * std::pow(x, 4));
        y = (y + (0.005 - open) * w) * (1 + w * (std::sqrt((1 - x) / (1 - x + 0.0025)) - 1));
        CAPTURE(x);
        CHECK(std::abs(shape->distance({x - 0.5, y})) < 2e-6);
        CHECK(std::abs(shape->distance({x - 0.5, -y})) < 2e-6);
      }
    }
  }
}

TEST_CASE("a blunt edge that is thicker than asked for keeps its thickness") {
  BodySettings body = through(section_of(60, 0.095));  // 0.0103 thick
  body.numbers["edge"] = 0.001;
  CHECK_THAT(told_of(body).back(),
             Contains("rounded with a radius of 0.00516 of it, half of what it is open"));
  CHECK(tip_of(body).radius == Approx(0.00516).epsilon(0.01));
}

TEST_CASE("a scale makes the body larger, an incidence turns it") {
  BodySettings body = through(section_of(40, 0.1015));
  const auto one = outline_of(body);
  body.numbers["scale"] = 3;
  CHECK(length_of(body) == 3);
  CHECK(outline_of(body)->perimeter() == Approx(3 * one->perimeter()).epsilon(1e-12));
  body.incidence = 90;
  CHECK(tip_of(body).place.y == Approx(-1.5).epsilon(1e-6));
}

TEST_CASE("points that make no outline are refused, with the first that is to blame") {
  Coordinates points = circle_of(40);
  CHECK(refusal(points).empty());
  points.pop_back();
  CHECK_THAT(refusal(points), Contains("point 40: there is an x without a y"));

  CHECK_THAT(refusal(circle_of(7)), Contains("there are 7 points; an outline has 8 at least"));
  CHECK_THAT(refusal(circle_of(1001)), Contains("1001 points; an outline has 1000 at most"));

  points = circle_of(40);
  points[21] = NAN;
  CHECK_THAT(refusal(points), Contains("point 11: the point is") && Contains("finite"));

  points = circle_of(40);
  points.insert(points.begin() + 22, {points[20], points[21]});
  CHECK_THAT(refusal(points),
             Contains("point 12: the point (") && Contains("same as the one before"));

  points = circle_of(40);
  std::swap(points[20], points[28]);
  std::swap(points[21], points[29]);
  CHECK_THAT(refusal(points), Contains("a corner") || Contains("crosses itself"));

  // A figure of eight.
  points.clear();
  for (int i = 0; i < 60; ++i) {
    points.push_back(std::sin(2 * pi * (i + 0.5) / 60));
    points.push_back(0.4 * std::sin(4 * pi * (i + 0.5) / 60));
  }
  CHECK_THAT(refusal(points), Contains("crosses itself: its sides at"));

  // Three quarters of a circle.
  points = circle_of(40);
  points.resize(60);
  CHECK_THAT(refusal(points), Contains("the outline is open: its last point"));

  // A square, of 40 points.
  points.clear();
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < 10; ++i) {
      const double angle = side * pi / 2, along = i / 10.0 - 0.45;
      points.push_back(0.5 * std::cos(angle) - along * std::sin(angle));
      points.push_back(0.5 * std::sin(angle) + along * std::cos(angle));
    }
  CHECK(refusal(points).empty());  // corners are cut by half a spacing: 45 degrees twice
  points.clear();
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < 10; ++i) {
      const double angle = side * pi / 2, along = i / 10.0 - 0.5;
      points.push_back(0.5 * std::cos(angle) - along * std::sin(angle));
      points.push_back(0.5 * std::sin(angle) + along * std::cos(angle));
    }
  CHECK_THAT(refusal(points), Contains("turns by 90 degrees at") && Contains("a corner"));

  BodySettings edged = through(circle_of(40));
  edged.numbers["edge"] = 0.01;
  CHECK_THAT(refusal(edged), Contains("body.edge is 0.01; the points have no trailing edge"));
}
