#include "sph/boundary/wall_nodes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "body/shapes/naca0012.hpp"

using namespace vortree;
using namespace vortree::sph;

namespace {

struct Outline {
  const char* name;
  std::unique_ptr<body::Shape> shape;
};

std::vector<Outline> outlines() {
  std::vector<Outline> all;
  all.push_back({"circle", body::circle({}, 0.5)});
  all.push_back({"ellipse", body::ellipse({}, 0.5, 0.2, 0.3)});
  all.push_back({"naca0012", body::naca0012({}, 1, 0.005, 0.1)});
  all.push_back({"naca0012 with a sharp edge", body::naca0012({}, 1, 2e-4, 0)});
  return all;
}

double apart(Vec2 a, Vec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// Lengths of the steps from each node to the next.
std::vector<double> steps(const std::vector<BoundaryNode>& nodes) {
  std::vector<double> all;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    all.push_back(apart(nodes[k].at, nodes[(k + 1) % nodes.size()].at));
  return all;
}

}  // namespace

TEST_CASE("nodes of a wall stand on it at equal arcs, and their normals are its own") {
  for (const auto& [name, shape] : outlines()) {
    CAPTURE(name);
    const int n = 64;
    const auto nodes = wall_nodes(*shape, n);
    REQUIRE(nodes.size() == 64);
    for (int k = 0; k < n; ++k) {
      const BoundaryNode& node = nodes[k];
      const body::WallPoint foot = shape->nearest(node.at);
      CHECK(foot.distance == Approx(0).margin(1e-12));
      CHECK(foot.arc == Approx((k + 0.5) * shape->perimeter() / n).epsilon(1e-9));
      CHECK(node.spacing == Approx(shape->perimeter() / n).epsilon(1e-15));
      CHECK(dot(node.normal, node.normal) == Approx(1).epsilon(1e-14));
      CHECK(shape->distance(node.at + 1e-3 * node.normal) == Approx(1e-3).epsilon(1e-6));
    }
    // Anticlockwise: the area that they go around is positive.
    double twice = 0;
    for (int k = 0; k < n; ++k) {
      const Vec2 a = nodes[k].at, b = nodes[(k + 1) % n].at;
      twice += a.x * b.y - a.y * b.x;
    }
    CHECK(twice > 0);
  }
}

TEST_CASE("rings stand at their distance from an outline, evenly, and in the gaps of each other") {
  const double spacing = 0.02;
  for (const auto& [name, shape] : outlines())
    for (int ring = 1; ring <= 4; ++ring) {
      const double d = ring * spacing;
      const auto nodes = ring_nodes(*shape, d, spacing, ring % 2 == 0);
      CAPTURE(name, ring);
      // Outlines that are convex have a parallel line longer by 2 pi d.
      const double length = shape->perimeter() + 2 * std::numbers::pi * d;
      CHECK(nodes.size() == static_cast<std::size_t>(std::lround(length / spacing)));
      for (const BoundaryNode& node : nodes) {
        CHECK(shape->distance(node.at) == Approx(d).epsilon(1e-9));
        const Vec2 normal = shape->nearest(node.at).normal;
        CHECK(dot(normal, node.normal) == Approx(1).epsilon(1e-9));
        CHECK(node.spacing == Approx(length / nodes.size()).epsilon(1e-14));
      }
      const auto all = steps(nodes);
      // Steps are equal in arc, to 2^-30 of places where the edge turns a radian in less than one.
      // Chords are shorter, most so around an edge, in circles of a radius of d or more.
      const double arc = length / nodes.size(), chord = 2 * d * std::sin(arc / (2 * d));
      CHECK(*std::ranges::max_element(all) < arc * (1 + 1e-6));
      CHECK(*std::ranges::min_element(all) > chord * (1 - 1e-6));
    }
}

TEST_CASE("a ring of a circle begins where the circle does, or half a step on") {
  const auto circle = body::circle({}, 0.5);
  const auto plain = ring_nodes(*circle, 0.1, 0.05, false),
             half = ring_nodes(*circle, 0.1, 0.05, true);
  REQUIRE(plain.size() == half.size());
  const double step = 2 * std::numbers::pi / static_cast<double>(plain.size());
  for (std::size_t k = 0; k < plain.size(); ++k) {
    const Vec2 a{0.6 * std::cos(k * step), 0.6 * std::sin(k * step)},
        b{0.6 * std::cos((k + 0.5) * step), 0.6 * std::sin((k + 0.5) * step)};
    // A circle turns evenly, so that what is linear between places is exact.
    CHECK(apart(plain[k].at, a) < 1e-9);
    CHECK(apart(half[k].at, b) < 1e-9);
  }
}
