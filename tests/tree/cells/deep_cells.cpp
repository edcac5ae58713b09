#include "tree/cells/deep_cells.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "tree/cells/exact_grid.hpp"
#include "tree/clouds.hpp"
#include "tree/neighbors/neighbors.hpp"
#include "tree/pairs.hpp"
#include "tree/reaches.hpp"

using namespace vortree;
using tree::ExactGrid;
using tree::Listing;
using tree::PairRule;

namespace {

double any_double(test::Chance& chance) {
  const double v = std::ldexp(1 + chance.real(), chance.whole(-1074, 1018));
  const int kind = chance.whole(0, 9);
  return kind == 0 ? 0.0 : kind < 6 ? v : -v;
}

struct Particles {
  test::Cloud cloud;
  std::vector<double> reach;

  // n more, evenly spread over a square; about 12 neighbors each, but for `wider`.
  void spread(int n, double x, double y, double side, test::Chance& chance, double wider = 1) {
    for (int i = 0; i < n; ++i) {
      cloud.add(x + side * chance.real(), y + side * chance.real());
      reach.push_back(wider * 2 * side / std::sqrt(n));
    }
  }
};

// Clouds that 29 levels cannot part.
std::vector<Particles> deep_clouds(int n, test::Chance& chance) {
  std::vector<Particles> made;
  const auto add = [&](const char* name) -> Particles& {
    made.push_back({{name, {}, {}}, {}});
    return made.back();
  };
  for (const double width : {1e-9, 1e-12}) {
    Particles& p = add("half in a cluster");
    p.spread(n / 2, 0, 0, 1, chance);
    p.spread(n / 2, 0.3, 0.7, width, chance);
  }
  Particles& origin = add("half in a cluster around the origin");
  origin.spread(n / 2, -1, -1, 2, chance);
  origin.spread(n / 2, -5e-201, -5e-201, 1e-200, chance);
  Particles& two = add("two far apart");
  two.spread(n / 2, 1, 1, 1e-10, chance);
  two.spread(n / 2, -1, -1, 1e-10, chance);
  for (const double far : {1e12, 1e300}) {
    Particles& p = add("an outlier");
    p.spread(n - 1, 0, 0, 1, chance);
    p.spread(1, far, -far / 7, 1, chance);
  }
  Particles& giant = add("an outlier and one that reaches all others");
  giant.spread(n - 2, 0, 0, 1, chance);
  giant.spread(1, 1e12, 1e11, 1, chance);
  giant.spread(1, 0.5, 0.5, 1, chance, 1e9);
  Particles& nested = add("one inside the other");
  for (int k = 0; k < 4; ++k) nested.spread(n / 4, 0.3, 0.3, std::pow(1e-4, k), chance);
  Particles& many = add("clusters of clusters");
  for (int k = 0; k < 9; ++k) {
    many.spread(n / 9, k % 3 + 1e-5 * (k / 3), k / 3, 1e-11, chance);
  }
  Particles& line = add("a line far away, evenly spread in y near zero");
  line.spread(n / 2, 0, 0, 1e6, chance);
  for (int i = 0; i < n / 2; ++i) {
    line.cloud.add(1e6, 1e-20 * chance.real());
    line.reach.push_back(1e-20 * 12 / n);
  }
  Particles& spacing = add("neighboring doubles");
  spacing.spread(1, -3, 5, 1, chance);
  const int side = static_cast<int>(std::sqrt(n));
  for (int i = 0; i < side * side; ++i) {
    spacing.cloud.add(1 + i % side * 0x1p-52, 1 + i / side * 0x1p-52);
    spacing.reach.push_back(2.5 * 0x1p-52);
  }
  Particles& tiny = add("all shorter than 1e-310");
  tiny.spread(n, 0, 0, 1e-310, chance);
  return made;
}

}  // namespace

TEST_CASE("levels and halves of an exact grid are those of the coordinates themselves") {
  test::Chance chance(95);
  for (int round = 0; round < 3000; ++round) {
    double farthest = std::abs(any_double(chance));
    const double wished = chance.whole(0, 5) == 0 ? 0 : std::abs(any_double(chance));
    const ExactGrid grid(farthest, wished);
    const double a = farthest * (2 * chance.real() - 1);
    const double b = a + farthest * (chance.real() - 0.5) * std::ldexp(1, -chance.whole(0, 60));
    if (std::abs(b) > farthest) continue;
    const int shared = grid.shared(a, b);
    CAPTURE(farthest, wished, a, b, shared);
    REQUIRE((shared == ExactGrid::bottom) == (a == b));
    // Equal halves down to the level of the cell they share, and different ones there.
    for (int level = 0; level <= std::min(shared, 120); ++level) {
      REQUIRE((grid.half(a, level) == grid.half(b, level)) == (level < shared));
    }
    const int level = chance.whole(0, 100);
    for (int k = 0; k < 31; ++k) {
      REQUIRE((grid.window(a, level) >> (30 - k) & 1) == grid.half(a, level + k));
    }
    if (a < b && shared < 30) REQUIRE(grid.window(a, 0) < grid.window(b, 0));
  }
}

TEST_CASE("the cells of an exact grid that span a reach are as wide, and not twice as wide") {
  test::Chance chance(96);
  for (int round = 0; round < 3000; ++round) {
    const double farthest = 1 + chance.real(), wished = chance.real();
    const ExactGrid grid(farthest, wished);
    const double reach = std::ldexp(1 + chance.real(), -chance.whole(1, 300));
    const double side = grid.side(grid.spanning(reach));
    REQUIRE(side >= reach * (1 - 1e-15));
    REQUIRE(side < 2 * reach * (1 + 1e-15));
    REQUIRE(grid.side(grid.spanning(wished)) < wished * 1.001);
    REQUIRE(grid.side(grid.spanning(wished)) >= wished * (1 - 1e-15));
  }
  CHECK(ExactGrid(1, 1).spanning(0) == ExactGrid::bottom);
  CHECK(ExactGrid(1, 1).spanning(1e300) == 0);
  CHECK(ExactGrid(1, 1).spanning(5e-324) > 1000);
}

TEST_CASE("cells of any depth hold their particles: sorted, each once, in the cell of its level") {
  test::Chance chance(97);
  for (const Particles& p : deep_clouds(700, chance)) {
    CAPTURE(p.cloud.name);
    tree::SortedParticles placed;
    (void)tree::sort_into_own_cells(p.cloud.points(), p.reach, placed);
    const tree::DeepCells deep = tree::deepen(placed, 4);
    std::vector<bool> seen(p.reach.size());
    for (std::size_t k = 0; k < placed.size; ++k) {
      const auto i = static_cast<std::size_t>(placed.id[k]);
      REQUIRE_FALSE(seen[i]);
      seen[i] = true;
      REQUIRE((placed.x[k] == p.cloud.x[i] && placed.y[k] == p.cloud.y[i]));
      REQUIRE(placed.reach[k] == p.reach[i]);
    }
    for (std::size_t c = 0; c < deep.cells.size(); ++c) {
      const tree::Cell& cell = deep.cells[c];
      const double side = deep.sides[cell.level];
      double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
      for (auto k = deep.first[cell.points.first]; k < deep.first[cell.points.last]; ++k) {
        left = std::min(left, placed.x[k]), right = std::max(right, placed.x[k]);
        low = std::min(low, placed.y[k]), high = std::max(high, placed.y[k]);
      }
      REQUIRE(std::max(right - left, high - low) <= side * (1 + 1e-15));
      std::uint32_t next = cell.children.empty() ? 0 : deep.cells[cell.children.first].points.first;
      for (auto k = cell.children.first; k < cell.children.last; ++k) {
        REQUIRE(deep.cells[k].level == cell.level + 1);
        REQUIRE(deep.cells[k].parent == static_cast<std::int32_t>(c));
        REQUIRE(deep.cells[k].points.first == next);
        next = deep.cells[k].points.last;
      }
      if (!cell.children.empty()) REQUIRE(next == cell.points.last);
    }
    for (std::size_t o = 0; o < deep.level.size(); ++o) {
      for (auto k = deep.first[o]; k < deep.first[o + 1]; ++k) {
        REQUIRE(deep.sides[std::min<std::size_t>(deep.level[o], deep.sides.size() - 1)] >=
                placed.reach[k] * (1 - 1e-15));
      }
    }
  }
}

TEST_CASE("lists of clouds that 29 levels cannot part are exact, every rule and listing") {
  test::Chance chance(98);
  tree::Neighbors search;
  for (const Particles& p : deep_clouds(1000, chance)) {
    CAPTURE(p.cloud.name);
    search.place(p.cloud.points(), p.reach);
    for (const PairRule rule : {PairRule::max, PairRule::mean, PairRule::own}) {
      test::Pairs truth;
      for (std::size_t i = 0; i < p.reach.size(); ++i) {
        for (std::size_t j = 0; j < p.reach.size(); ++j) {
          const double dx = p.cloud.x[j] - p.cloud.x[i], dy = p.cloud.y[j] - p.cloud.y[i];
          const double ri = p.reach[i], rj = p.reach[j];
          const bool near = rule == PairRule::max    ? tree::within<PairRule::max>(dx, dy, ri, rj)
                            : rule == PairRule::mean ? tree::within<PairRule::mean>(dx, dy, ri, rj)
                                                     : tree::within<PairRule::own>(dx, dy, ri, rj);
          if (j != i && near) truth.emplace_back(i, j);
        }
      }
      tree::PairList rows;
      for (const Listing listing : {Listing::both_ways, Listing::once}) {
        if (rule == PairRule::own && listing == Listing::once) continue;
        search.list(rule, listing, rows);
        REQUIRE((test::pairs_of(rows, listing) == truth));
      }
    }
  }
}

// A uniform cloud has some 110 candidates a particle, both ways. A crowd of 128 is searched whole,
// and with it those of eight crowded cells around: 1152 at most, and again what coarser particles
// look at. It does not grow with n.
TEST_CASE("candidates grow like the number of particles, in clusters of any depth") {
  test::Chance chance(99);
  tree::Neighbors search;
  for (const int n : {20000, 80000}) {
    for (const Particles& p : deep_clouds(n, chance)) {
      CAPTURE(p.cloud.name, n);
      search.place(p.cloud.points(), p.reach);
      const auto both = static_cast<double>(search.candidates(Listing::both_ways));
      CHECK(both < 300.0 * n);
      CHECK(static_cast<double>(search.candidates(Listing::once)) < 200.0 * n);
    }
  }
}
