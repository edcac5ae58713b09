#include "tree/neighbors/ball_search.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tree/clouds.hpp"
#include "tree/neighbors/pair_rule.hpp"
#include "tree/reaches.hpp"

using namespace vortree;

// Compiled without fused operations, as the rule asks for: tree/neighbors/pair_rule.hpp.
namespace {

std::vector<std::int32_t> all_near(tree::Points points, double x, double y, double r) {
  std::vector<std::int32_t> found;
  for (std::size_t j = 0; j < points.size(); ++j)
    if (tree::within<tree::PairRule::own>(points.x[j] - x, points.y[j] - y, r, r))
      found.push_back(static_cast<std::int32_t>(j));
  return found;
}

bool lists_all(const test::Cloud& cloud, const test::Cloud& places,
               const std::vector<double>& radius) {
  tree::PairList rows;
  tree::BallSearch(cloud.points()).list(places.points(), radius, rows);
  bool same = rows.size() == radius.size();
  for (std::size_t i = 0; same && i < radius.size(); ++i)
    same = std::ranges::equal(rows.row(i),
                              all_near(cloud.points(), places.x[i], places.y[i], radius[i]));
  return same;
}

}  // namespace

TEST_CASE("a ball holds just the points for which the rule says so, in any cloud") {
  test::Chance chance(71);
  for (int round = 0; round < 400; ++round) {
    const test::Cloud cloud = test::any_cloud(300, chance);
    test::Cloud places = test::any_cloud(60, chance);
    for (std::size_t i = 0; i < cloud.x.size(); i += 7) places.add(cloud.x[i], cloud.y[i]);
    const int kind = chance.whole(0, test::reach_kinds - 1);
    const double extent = chance.whole(0, 1) ? test::extent_of(cloud) : test::extent_of(places);
    CAPTURE(round, cloud.name, places.name, kind);
    REQUIRE(lists_all(cloud, places, test::make_reach(kind, places.x.size(), extent, chance)));
  }
}

TEST_CASE("a ball of lattice points whose radius is their distance ends just before them") {
  test::Cloud lattice, middle;
  for (int i = 0; i < 400; ++i) lattice.add(0.1 * (i % 20), 0.1 * (i / 20));
  middle.add(lattice.x[210], lattice.y[210]);
  for (const std::size_t other : {211u, 230u, 231u}) {
    const double dx = lattice.x[other] - middle.x[0], dy = lattice.y[other] - middle.y[0];
    for (const double r : {std::sqrt(dx * dx + dy * dy), dx, dy})
      CHECK(lists_all(lattice, middle, {r}));
  }
}

TEST_CASE("lengths of any size are compared as those of one") {
  for (const double unit : {1e-300, 1e-170, 1e170, 1e300}) {
    CAPTURE(unit);
    test::Chance chance(72);
    test::Cloud cloud = test::make_cloud(0, 200, chance), places = test::make_cloud(0, 20, chance);
    for (auto* values : {&cloud.x, &cloud.y, &places.x, &places.y})
      for (double& value : *values) value *= unit;
    CHECK(lists_all(cloud, places, std::vector(places.x.size(), 0.2 * unit)));
  }
}

TEST_CASE("what is no place, no point or no radius is refused, with its number") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> some{0, 1}, bad{0, nan}, negative{1, -1}, one{1};
  tree::PairList rows;
  CHECK_THROWS_WITH(tree::BallSearch({some, bad}), Catch::Contains("y[1] is nan"));
  CHECK_THROWS_WITH(tree::BallSearch({some, one}), Catch::Contains("2 x but 1 y"));
  const tree::BallSearch search({some, some});
  CHECK_THROWS_WITH(search.list({bad, some}, some, rows), Catch::Contains("x[1] is nan"));
  CHECK_THROWS_WITH(search.list({some, some}, one, rows), Catch::Contains("1 radii, 2 places"));
  CHECK_THROWS_WITH(search.list({some, some}, negative, rows),
                    Catch::Contains("radius[1] is -1; it must be finite and >= 0"));
  rows.most = 3;
  CHECK_THROWS_AS(search.list({some, some}, std::vector{2.0, 2.0}, rows), std::length_error);
}
