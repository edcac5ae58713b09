#include "sph/boundary/outer_box.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <utility>

using namespace vortree;
using namespace vortree::sph;

namespace {

const OuterBox box{{-2, -1}, {3, 1.5}};

}  // namespace

TEST_CASE("nodes go once around a box, a step apart, with normals into it") {
  const auto nodes = box_nodes(box, 0.24);
  const int across = 21, up = 10;  // 5/0.24 and 2.5/0.24, rounded
  REQUIRE(nodes.size() == 2 * (across + up));
  std::set<std::pair<double, double>> places;
  int corners = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto& [at, normal, spacing] = nodes[k];
    CAPTURE(k, at.x, at.y);
    places.insert({at.x, at.y});
    CHECK(std::abs(box.depth(at)) < 1e-15 * 5);
    CHECK(dot(normal, normal) == 1);
    CHECK(spacing == Approx(normal.x == 0 ? 5.0 / across : 2.5 / up).epsilon(1e-15));
    const bool is_corner = corner(box, at);
    corners += is_corner;
    if (is_corner)
      CHECK(normal.y == 0);
    else
      CHECK(box.depth(at + 0.1 * normal) == Approx(0.1).epsilon(1e-12));
    const Vec2 next = nodes[(k + 1) % nodes.size()].at, step = next - at;
    CHECK(std::hypot(step.x, step.y) ==
          Approx(step.x == 0 ? 2.5 / up : 5.0 / across).epsilon(1e-12));
    CHECK((at.x * step.y - at.y * step.x) > 0);  // anticlockwise about the origin, which is inside
  }
  CHECK(places.size() == nodes.size());
  CHECK(corners == 4);
}

TEST_CASE("a box smaller than the spacing has its corners and the middles of its sides") {
  CHECK(box_nodes({{0, 0}, {1, 1}}, 10).size() == 8);
}

TEST_CASE("the depth is that to the nearest side, negative outside") {
  CHECK(box.depth({0, 0}) == 1);
  CHECK(box.depth({2.75, 0}) == 0.25);
  CHECK(box.depth({0, 1.25}) == 0.25);
  CHECK(box.depth({-2.5, 0}) == -0.5);
  CHECK(box.depth({4, 3}) == -1.5);
  CHECK(corner(box, {3, 1.5}));
  CHECK_FALSE(corner(box, {3, 1.4}));
  CHECK_FALSE(corner(box, {0, 1.5}));
}
