#include "body/outlines/shape_group.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "body/shapes/naca0012.hpp"
#include "vortex/flows.hpp"

using namespace vortree;
using body::PlacedShape;

namespace {

std::shared_ptr<const body::Shape> ellipse() {
  return body::ellipse({}, 0.5, 0.2, 0.3);
}

}  // namespace

TEST_CASE("a shape that is placed elsewhere and turned is the shape, seen from there") {
  const auto shape = ellipse();
  const Vec2 at{3, -2};
  const PlacedShape placed(shape, at, 0.7);
  const Turn turn(0.7);
  CHECK(placed.perimeter() == shape->perimeter());
  bench::Uniform uniform(3);
  for (int k = 0; k < 200; ++k) {
    const Vec2 from{3 * (uniform() - 0.5), 3 * (uniform() - 0.5)}, there = at + turn(from);
    const body::WallPoint a = shape->nearest(from), b = placed.nearest(there);
    CHECK(b.distance == Approx(a.distance).margin(1e-14));
    CHECK(placed.distance(there) == Approx(a.distance).margin(1e-14));
    CHECK(b.arc == Approx(a.arc).margin(1e-13));
    CHECK(b.curvature == Approx(a.curvature).epsilon(1e-11));
    CHECK(dot(b.normal, turn(a.normal)) == Approx(1).epsilon(1e-13));
    const Vec2 back = placed.point(b.arc) + b.distance * b.normal - there;
    CHECK(std::hypot(back.x, back.y) < 1e-13);
    CHECK((!placed.beyond(there, 0.1) || a.distance > 0.1));
  }
}

TEST_CASE("the nearest place of several bodies is the nearest of each") {
  const std::vector<std::shared_ptr<const body::Shape>> members{
      body::circle({}, 0.5), std::make_shared<PlacedShape>(ellipse(), Vec2{1.2, 0.1}, 0.4),
      std::make_shared<PlacedShape>(body::naca0012({}, 1, 0.005, 0.1), Vec2{-0.3, 1.1})};
  const body::ShapeGroup group(members);
  double all = 0;
  for (const auto& one : members) all += one->perimeter();
  CHECK(group.perimeter() == all);
  CHECK(group.perimeters().size() == 3);
  bench::Uniform uniform(9);
  for (int k = 0; k < 500; ++k) {
    const Vec2 at{5 * (uniform() - 0.4), 4 * (uniform() - 0.4)};
    double first = 0, before = 0;
    std::size_t curve = 0;
    body::WallPoint best{0, INFINITY, {}, 0};
    for (std::size_t m = 0; m < members.size(); ++m) {
      const body::WallPoint found = members[m]->nearest(at);
      if (found.distance < best.distance) best = found, before = first, curve = m;
      first += members[m]->perimeter();
    }
    const body::WallPoint found = group.nearest(at);
    CHECK(found.distance == best.distance);
    CHECK(group.distance(at) == Approx(best.distance).margin(1e-14));
    CHECK(found.arc == Approx(before + best.arc).margin(1e-14));
    CHECK(found.normal == best.normal);
    CHECK(group.curve_at(found.arc) == curve);
    CHECK((!group.beyond(at, 0.2) || best.distance > 0.2));
    const Vec2 back = group.point(found.arc) + found.distance * found.normal - at;
    CHECK(std::hypot(back.x, back.y) < 1e-12);
  }
}

TEST_CASE("beside where a body's arc begins, round-off carries no arc to another body") {
  const auto circle = std::shared_ptr<const body::Shape>(body::circle({}, 0.5));
  for (const double far : {16.0, 18.0, 60.0, 1000.0}) {
    const body::ShapeGroup group({circle, std::make_shared<PlacedShape>(ellipse(), Vec2{0, -far})});
    const double begins = circle->perimeter(), ends = group.perimeter();
    const Vec2 at = group.point(begins);
    for (const double off : {-1e-3, -1e-12, 0.0, 1e-12, 1e-3})
      for (const double along : {-1e-9, -1e-14, 0.0, 1e-14, 1e-9}) {
        const body::WallPoint there = group.nearest(at);
        const Vec2 near = at + off * there.normal + along * there.tangent();
        const double arc = group.nearest(near).arc;
        CHECK((arc >= begins && arc < ends));
      }
  }
}

TEST_CASE("the gap between two bodies is that of their nearest places") {
  const auto circle = std::shared_ptr<const body::Shape>(body::circle({}, 0.5));
  const auto gap = [&](Vec2 at, double angle = 0) {
    return body::gap_between({circle, {0.1, 0.2}},
                             {body::ellipse({}, 0.5, 0.1, 0), Vec2{0.1, 0.2} + at, angle});
  };
  CHECK(gap({2, 0}) == Approx(1).epsilon(1e-12));
  CHECK(gap({0, 0.7}) == Approx(0.1).epsilon(1e-11));
  CHECK(gap({0, 1.5}, std::numbers::pi / 2) == Approx(0.5).epsilon(1e-12));
  CHECK(gap({0.9, 0}) == Approx(-0.1).epsilon(1e-3));  // they cross: how deep, roughly
  CHECK(gap({0.05, 0}) < 0);                           // they cross
  const auto within = body::gap_between({circle, {}}, {body::ellipse({}, 0.2, 0.1, 0), {0.1, 0}});
  CHECK(within < 0);  // one holds the other
}
