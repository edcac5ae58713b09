#include "tree/neighbors/crossing_pairs.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tree/clouds.hpp"
#include "tree/neighbors/ball_search.hpp"
#include "tree/pairs.hpp"
#include "tree/reaches.hpp"

using namespace vortree;
using tree::Listing;
using tree::PairRule;
using tree::PeriodicBox;

// Compiled without fused operations, as the rule asks for: tree/neighbors/pair_rule.hpp.
namespace {

// Of d - L, d and d + L the one nearest to zero, each for itself: no formula of the library.
double least_image(double d, double length) {
  if (length == 0) return d;
  return std::min({std::abs(d), std::abs(d - length), std::abs(d + length)});
}

bool near_in_box(const test::Cloud& c, const PeriodicBox& box, std::size_t j, double x, double y,
                 double r) {
  const double dx = least_image(c.x[j] - x, box.x), dy = least_image(c.y[j] - y, box.y);
  return tree::within<PairRule::own>(dx, dy, r, r);
}

double pair_reach(PairRule rule, double ri, double rj) {
  return rule == PairRule::max ? std::max(ri, rj) : rule == PairRule::mean ? 0.5 * (ri + rj) : ri;
}

test::Pairs all_in_box(const test::Cloud& c, const std::vector<double>& reach,
                       const PeriodicBox& box, PairRule rule) {
  test::Pairs pairs;
  for (std::size_t i = 0; i < reach.size(); ++i)
    for (std::size_t j = 0; j < reach.size(); ++j)
      if (i != j && near_in_box(c, box, j, c.x[i], c.y[i], pair_reach(rule, reach[i], reach[j])))
        pairs.emplace_back(i, j);
  return pairs;
}

// Any kind of cloud, moved and scaled into a box: some fill it, some stand at its edges, where the
// least and the largest coordinates are.
test::Cloud cloud_in(const PeriodicBox& box, int most, test::Chance& chance) {
  test::Cloud cloud =
      test::make_cloud(chance.whole(0, test::cloud_kinds - 1), chance.whole(1, most), chance);
  const auto fit = [&](std::vector<double>& values, double length) {
    if (length == 0) return;
    const auto [low, high] = std::ranges::minmax(values);
    const double width = high > low ? high - low : 1;
    const bool small = chance.whole(0, 3) == 0, over = chance.whole(0, 1) == 1;
    for (double& x : values) {
      x = (x - low) / width * length * (small ? 1e-6 : 1);
      // A narrow cloud across the edge, or one against it.
      if (over && small) x = x < 5e-7 * length ? x : length - (1e-6 * length - x);
      x = std::min(x, std::nextafter(length, 0));
    }
  };
  fit(cloud.x, box.x), fit(cloud.y, box.y);
  return cloud;
}

PeriodicBox any_box(test::Chance& chance) {
  const bool odd = chance.whole(0, 9) == 0;
  const double unit = std::pow(10.0, odd ? chance.whole(-300, 300) : chance.whole(-6, 6));
  const int directions = chance.whole(1, 3);
  return {directions & 1 ? unit * (0.5 + chance.real()) : 0,
          directions & 2 ? unit * (0.5 + chance.real()) : 0};
}

std::vector<double> some_reach(const test::Cloud& cloud, std::size_t n, test::Chance& chance) {
  std::vector<double> reach =
      test::make_reach(chance.whole(0, test::reach_kinds - 1), n, test::extent_of(cloud), chance);
  for (double& r : reach) r = std::min(r, std::numeric_limits<double>::max());
  return reach;
}

}  // namespace

TEST_CASE("lists in a periodic box hold just the pairs of nearest images, in any cloud") {
  test::Chance chance(81);
  std::size_t across = 0;
  for (int round = 0; round < 600; ++round) {
    const PeriodicBox box = any_box(chance);
    const test::Cloud cloud = cloud_in(box, 120, chance);
    const std::vector<double> reach = some_reach(cloud, cloud.x.size(), chance);
    for (const PairRule rule : {PairRule::max, PairRule::mean, PairRule::own}) {
      const test::Pairs truth = all_in_box(cloud, reach, box, rule);
      across += truth.size() - all_in_box(cloud, reach, {}, rule).size();
      for (const Listing listing : {Listing::both_ways, Listing::once}) {
        if (rule == PairRule::own && listing == Listing::once) continue;
        CAPTURE(round, cloud.name, box.x, box.y, static_cast<int>(rule));
        const tree::PairList rows = tree::neighbors(cloud.points(), reach, box, rule, listing);
        REQUIRE((test::pairs_of(rows, listing) == truth));
      }
    }
  }
  CHECK(across > 10000);
}

TEST_CASE("reaches of the box's half, of all of it and beyond count each pair once") {
  test::Chance chance(82);
  for (const PeriodicBox box : {PeriodicBox{1, 1}, PeriodicBox{1, 0}, PeriodicBox{0.3, 2}}) {
    const test::Cloud cloud = cloud_in(box, 60, chance);
    for (const double r : {0.5, std::nextafter(0.5, 1), 0.7, 1.0, 3.0}) {
      const std::vector<double> reach(cloud.x.size(), r);
      const tree::PairList rows = tree::neighbors(cloud.points(), reach, box, PairRule::max);
      REQUIRE((test::pairs_of(rows, Listing::both_ways) ==
               all_in_box(cloud, reach, box, PairRule::max)));
    }
  }
}

TEST_CASE("on a lattice that goes around a reach of one spacing ends just before the next") {
  constexpr int n = 12;
  test::Cloud lattice;
  for (int i = 0; i < n * n; ++i) lattice.add(i % n, i / n);
  const PeriodicBox box{n, n};
  const auto pairs = [&](double r) {
    const std::vector<double> reach(n * n, r);
    return tree::neighbors(lattice.points(), reach, box, PairRule::max).index.size();
  };
  CHECK(pairs(0) == 0);
  CHECK(pairs(1) == 0);
  CHECK(pairs(std::nextafter(1, 2)) == 4 * n * n);
  CHECK(pairs(1.9) == 8 * n * n);
  // The farthest is half around in both directions, sqrt(72) = 8.49 away.
  CHECK(pairs(8.25) == (n * n - 2) * n * n);
  CHECK(pairs(8.5) == (n * n - 1) * n * n);
}

TEST_CASE("lists do not move with the box: what is shifted around it has the same neighbors") {
  // Coordinates and lengths are whole numbers over 2^20: sums of them are exact.
  test::Chance chance(83);
  constexpr double unit = 0x1p-20;
  const PeriodicBox box{0x1p20 * unit, 0xc0000 * unit};
  test::Cloud cloud;
  std::vector<double> reach;
  for (int i = 0; i < 400; ++i) {
    cloud.add(chance.whole(0, 0xfffff) * unit, chance.whole(0, 0xbffff) * unit);
    reach.push_back(chance.whole(0, 0x20000) * unit);
  }
  const auto all = [&](const test::Cloud& c) {
    const auto rows = tree::neighbors(c.points(), reach, box, PairRule::mean);
    return test::pairs_of(rows, Listing::both_ways);
  };
  const test::Pairs before = all(cloud);
  CHECK(before.size() > 1000);
  for (int round = 0; round < 20; ++round) {
    const double a = chance.whole(0, 0xfffff) * unit, b = chance.whole(0, 0xbffff) * unit;
    test::Cloud moved;
    for (std::size_t i = 0; i < cloud.x.size(); ++i)
      moved.add(tree::image_in_box(cloud.x[i] + a, box.x),
                tree::image_in_box(cloud.y[i] - b, box.y));
    REQUIRE((all(moved) == before));
  }
}

TEST_CASE("a ball in a periodic box holds the points whose nearest images it holds") {
  test::Chance chance(84);
  for (int round = 0; round < 300; ++round) {
    const PeriodicBox box = any_box(chance);
    const test::Cloud cloud = cloud_in(box, 200, chance), places = cloud_in(box, 40, chance);
    const std::vector<double> radius = some_reach(cloud, places.x.size(), chance);
    tree::PairList rows;
    tree::BallSearch(cloud.points(), box).list(places.points(), radius, rows);
    for (std::size_t i = 0; i < radius.size(); ++i) {
      std::vector<std::int32_t> truth;
      for (std::size_t j = 0; j < cloud.x.size(); ++j)
        if (near_in_box(cloud, box, j, places.x[i], places.y[i], radius[i]))
          truth.push_back(static_cast<std::int32_t>(j));
      CAPTURE(round, i, cloud.name, places.name, box.x, box.y);
      REQUIRE(std::ranges::equal(rows.row(i), truth));
    }
  }
}

TEST_CASE("a place outside the box stands for its image inside") {
  CHECK(tree::image_in_box(2.25, 1) == 0.25);
  CHECK(tree::image_in_box(-0.25, 1) == 0.75);
  CHECK(tree::image_in_box(-1e-300, 1) == 0);  // 1 - 1e-300 is rounded to 1, which is 0
  CHECK(tree::image_in_box(1, 1) == 0);
  CHECK(tree::image_in_box(-7, 0) == -7);
  const std::vector<double> x{0.125, 0.5}, y{0.5, 0.5}, far{-2.75}, above{3.5}, radius{0.25};
  tree::PairList rows;
  tree::BallSearch({x, y}, {1, 1}).list({far, above}, radius, rows);
  CHECK(std::ranges::equal(rows.row(0), std::vector{0}));
}

TEST_CASE("what is not in the box, or no box, is refused with its number") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> zero{0, 0}, some{0, 1}, below{0, -0.5}, bad{0, nan};
  const auto ask = [&](const std::vector<double>& x, const std::vector<double>& y,
                       const PeriodicBox& box) {
    return tree::neighbors({x, y}, some, box, PairRule::max);
  };
  CHECK_THROWS_WITH(ask(some, zero, {1, 1}), "x[1] is 1; in the periodic box it must be in [0, 1)");
  CHECK_THROWS_WITH(ask(zero, below, {0, 2}),
                    "y[1] is -0.5; in the periodic box it must be in [0, 2)");
  CHECK_THROWS_WITH(ask(zero, bad, {1, 1}), Catch::Contains("y[1] is nan"));
  CHECK_THROWS_WITH(ask(zero, zero, {-1, 0}),
                    "the periodic box has the length -1 along x; it must "
                    "be finite and >= 0");
  CHECK_THROWS_WITH(ask(zero, zero, {1, nan}), Catch::Contains("length nan along y"));
  CHECK(ask(below, below, {}).index.size() == 2);
  CHECK(ask(below, zero, {0, 1}).index.size() == 2);
  CHECK_THROWS_WITH(tree::BallSearch({some, zero}, {1, 1}), Catch::Contains("x[1] is 1"));
  tree::PairList rows = tree::neighbors({zero, zero}, some, PairRule::max);
  const std::vector<double> apart{0, 0.75};
  rows = tree::neighbors({apart, zero}, std::vector{0.5, 0.5}, PairRule::max);
  rows.most = 1;
  const tree::CrossingPairs crossing({apart, zero}, std::vector{0.5, 0.5}, {1, 1});
  CHECK_THROWS_AS(crossing.add_to(PairRule::max, Listing::both_ways, rows), std::length_error);
}
