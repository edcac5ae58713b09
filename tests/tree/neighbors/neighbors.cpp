#include "tree/neighbors/neighbors.hpp"

#include <omp.h>

#include <catch2/catch.hpp>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "tree/build/build_forward.hpp"
#include "tree/build/split_rule.hpp"
#include "tree/pairs.hpp"
#include "tree/reaches.hpp"

using namespace vortree;
using Catch::Matchers::Contains;
using tree::Listing;
using tree::PairRule;

namespace {

constexpr PairRule every_rule[] = {PairRule::max, PairRule::mean, PairRule::own};

bool asked(PairRule rule, Listing listing) {
  return rule != PairRule::own || listing == Listing::both_ways;
}

// Compares the lists of placed particles with all pairs, every rule and listing.
void check_lists(tree::Neighbors& search, tree::Points points, std::span<const double> reach) {
  tree::PairList rows;
  for (const PairRule rule : every_rule) {
    const test::Pairs truth = test::all_pairs(points, reach, rule);
    for (const Listing listing : {Listing::both_ways, Listing::once}) {
      if (!asked(rule, listing)) continue;
      CAPTURE(static_cast<int>(rule), static_cast<int>(listing), points.size());
      search.list(rule, listing, rows);
      REQUIRE(rows.size() == points.size());
      const bool equal = test::pairs_of(rows, listing) == truth;
      REQUIRE(equal);
    }
  }
}

void check_all(tree::Points points, std::span<const double> reach, tree::Neighbors& search) {
  search.place(points, reach);
  check_lists(search, points, reach);
}

void check_all(const tree::Quadtree& tree, tree::Points points, std::span<const double> reach,
               tree::Neighbors& search) {
  search.place(tree, points, reach);
  check_lists(search, points, reach);
}

struct Particles {
  test::Cloud cloud;
  std::vector<double> reach;
};

Particles any_particles(int most, test::Chance& chance) {
  Particles made{test::any_cloud(most, chance), {}};
  const int kind = chance.whole(0, test::reach_kinds - 1);
  made.reach = test::make_reach(kind, made.cloud.x.size(), test::extent_of(made.cloud), chance);
  return made;
}

}  // namespace

TEST_CASE("lists hold exactly the pairs that a test of all pairs finds, none twice") {
  test::Chance chance(31);
  tree::Neighbors search;  // the same for all: nothing of an earlier set may be left in it
  for (int kind = 0; kind < test::cloud_kinds; ++kind) {
    for (int reach_kind = 0; reach_kind < test::reach_kinds; ++reach_kind) {
      for (const int n : {0, 1, 2, 7, 60, 300, 700}) {
        const test::Cloud cloud = test::make_cloud(kind, n, chance);
        const auto reach = test::make_reach(reach_kind, cloud.x.size(), 1.0, chance);
        CAPTURE(cloud.name, reach_kind);
        check_all(cloud.points(), reach, search);
      }
    }
  }
}

TEST_CASE("anywhere, at any scale, and with any tree of the points, the lists are the same") {
  test::Chance chance(32);
  tree::Neighbors search;
  for (int round = 0; round < 150; ++round) {
    const auto [cloud, reach] = any_particles(250, chance);
    CAPTURE(round, cloud.name);
    const tree::Points points = cloud.points();
    check_all(points, reach, search);
    const int finest = chance.whole(0, tree::max_level);
    tree::MortonOrder order = tree::morton_order(points, tree::enclose(points), finest);
    const auto capacity = static_cast<std::uint32_t>(chance.whole(1, 30));
    check_all(tree::build_forward(order, tree::crowded(capacity)), points, reach, search);
    std::vector<double> sorted(reach.size());
    for (std::size_t j = 0; j < sorted.size(); ++j) sorted[j] = reach[order.index[j]];
    order.finest = finest;
    check_all(tree::build_forward(std::move(order), tree::roomy(sorted)), points, reach, search);
  }
}

TEST_CASE("distances equal to the reach, or off by a last bit, are told apart") {
  test::Chance chance(33);
  tree::Neighbors search;
  for (const double spacing : {1.0, 0.1, 1.0 / 3}) {
    Particles p;
    for (int i = 0; i < 400; ++i) p.cloud.add(i % 20 * spacing, i / 20 * spacing);
    for (int i = 0; i < 400; ++i) {
      const double r = chance.whole(1, 5) * spacing;
      const int way = chance.whole(-1, 1);
      p.reach.push_back(way == 0 ? r : std::nextafter(r, way * 1e9));
    }
    check_all(p.cloud.points(), p.reach, search);
  }
}

TEST_CASE("a large cluster of coincident points in a fine set is listed in full") {
  test::Chance chance(34);
  Particles p{test::make_cloud(0, 1500, chance), {}};
  for (int i = 0; i < 500; ++i) p.cloud.add(0.3, 0.7);
  p.reach.assign(p.cloud.x.size(), 0.05);
  tree::Neighbors search;
  check_all(p.cloud.points(), p.reach, search);
}

TEST_CASE("the visitor is shown the rows of the list") {
  test::Chance chance(35);
  for (int round = 0; round < 40; ++round) {
    const auto [cloud, reach] = any_particles(600, chance);
    tree::Neighbors search;
    search.place(cloud.points(), reach);
    for (const PairRule rule : every_rule) {
      for (const Listing listing : {Listing::both_ways, Listing::once}) {
        if (!asked(rule, listing)) continue;
        tree::PairList rows;
        search.list(rule, listing, rows);
        std::vector<std::vector<std::int32_t>> shown(cloud.x.size());
        search.visit(rule, listing, [&](std::int32_t i, std::span<const std::int32_t> row) {
          shown[static_cast<std::size_t>(i)].assign(row.begin(), row.end());
        });
        for (std::size_t i = 0; i < shown.size(); ++i) {
          const auto row = rows.row(i);
          REQUIRE(std::equal(row.begin(), row.end(), shown[i].begin(), shown[i].end()));
        }
      }
    }
  }
}

TEST_CASE("rows do not depend on the number of threads") {
  test::Chance chance(36);
  const test::Cloud cloud = test::make_cloud(0, 20000, chance);
  const auto reach = test::make_reach(1, cloud.x.size(), 1.0, chance);
  const int all = omp_get_max_threads();
  std::vector<tree::PairList> rows;
  for (const int threads : {1, 2, 3, 7}) {
    omp_set_num_threads(threads);
    rows.push_back(tree::neighbors(cloud.points(), reach, PairRule::max));
  }
  omp_set_num_threads(all);
  for (const tree::PairList& other : rows) {
    CHECK(std::ranges::equal(other.start.span(), rows[0].start.span()));
    CHECK(std::ranges::equal(other.index.span(), rows[0].index.span()));
  }
  CHECK(rows[0].index.size() > 20000);
}

TEST_CASE("each pair once lists half of both ways") {
  test::Chance chance(37);
  const test::Cloud cloud = test::make_cloud(0, 3000, chance);
  const auto reach = test::make_reach(2, cloud.x.size(), 1.0, chance);
  const auto both = tree::neighbors(cloud.points(), reach, PairRule::max);
  const auto once = tree::neighbors(cloud.points(), reach, PairRule::max, Listing::once);
  CHECK(2 * once.index.size() == both.index.size());
}

TEST_CASE("what cannot be searched is refused with numbers") {
  const std::vector<double> x{0, 1, 2}, y{0, 1, 0};
  const std::vector<double> reach{1, 1, 1};
  const tree::Points points{x, y};
  const tree::Quadtree tree =
      tree::build_forward(tree::morton_order(points, tree::enclose(points)), tree::crowded(1));
  tree::Neighbors search;
  for (const double bad :
       {-0.5, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const std::vector<double> broken{1, bad, 1};
    CHECK_THROWS_WITH(search.place(tree, points, broken), Contains("reach[1] is "));
    CHECK_THROWS_WITH(search.place(points, broken), Contains("reach[1] is "));
  }
  const std::vector<double> few{1, 1};
  CHECK_THROWS_WITH(search.place(tree, points, few), Contains("3 points but 2 reaches"));
  CHECK_THROWS_WITH(search.place(tree, {few, few}, few),
                    Contains("2 points, but the tree holds 3"));
  CHECK_THROWS_WITH(search.place({x, few}, reach), Contains("3 x but 2 y"));
  search.place(tree, points, reach);
  tree::PairList rows;
  CHECK_THROWS_WITH(search.list(PairRule::own, Listing::once, rows), Contains("not symmetric"));
}

TEST_CASE("more pairs than may be listed are refused with both numbers, by any number of threads") {
  test::Chance chance(38);
  const test::Cloud cloud = test::make_cloud(0, 20000, chance);
  const auto reach = test::make_reach(0, cloud.x.size(), 1.0, chance);
  tree::Neighbors search;
  search.place(cloud.points(), reach);
  tree::PairList rows;
  search.list(PairRule::max, Listing::both_ways, rows);
  const auto pairs = static_cast<std::int64_t>(rows.index.size());
  const int all = omp_get_max_threads();
  for (const int threads : {1, 4}) {
    omp_set_num_threads(threads);
    rows.most = pairs - 1;
    CHECK_THROWS_WITH(search.list(PairRule::max, Listing::both_ways, rows),
                      Contains(std::to_string(pairs) + " pairs and more") &&
                          Contains("at most " + std::to_string(pairs - 1)));
    rows.most = pairs;
    search.list(PairRule::max, Listing::both_ways, rows);
    CHECK(rows.index.size() == static_cast<std::size_t>(pairs));
    const auto stop = [](std::int32_t i, std::span<const std::int32_t>) {
      if (i == 1234) throw std::runtime_error("enough");
    };
    CHECK_THROWS_WITH(search.visit(PairRule::max, Listing::both_ways, stop), "enough");
  }
  omp_set_num_threads(all);
}

TEST_CASE("more than 2^32 pairs are counted") {
  const std::size_t n = 65537;
  const std::vector<double> place(n, 0.5), reach(n, 1.0);
  tree::Neighbors search;
  search.place({place, place}, reach);
  std::vector<std::size_t> shown(n);
  search.visit(PairRule::max, Listing::both_ways,
               [&](std::int32_t i, std::span<const std::int32_t> row) {
                 shown[static_cast<std::size_t>(i)] = row.size();
               });
  CHECK(std::accumulate(shown.begin(), shown.end(), std::uint64_t{0}) == n * (n - 1));
  CHECK(n * (n - 1) > std::uint64_t{1} << 32);
}
