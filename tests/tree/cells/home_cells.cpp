#include "tree/cells/home_cells.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "tree/build/build_forward.hpp"
#include "tree/build/split_rule.hpp"
#include "tree/cells/home_cell_kernel.hpp"
#include "tree/clouds.hpp"
#include "tree/order/digit_sort.hpp"
#include "tree/reaches.hpp"

using namespace vortree;

namespace {

struct Cells {
  tree::HomeCells own;
  tree::SortedParticles placed;
};

// Every particle is placed once, in a cell that spans its reach, holds it, and is the deepest such.
void check_cells(const Cells& cells, tree::Points points, std::span<const double> reach) {
  const auto& [own, placed] = cells;
  const std::size_t n = points.size();
  REQUIRE(own.first.size() == own.size() + 1);
  REQUIRE(own.first.back() == n);
  std::vector<bool> seen(n);
  for (std::size_t c = 0; c < own.size(); ++c) {
    REQUIRE(own.first[c] < own.first[c + 1]);
    if (c > 0) {
      REQUIRE(std::pair(own.corner[c - 1], own.level[c - 1]) <
              std::pair(own.corner[c], own.level[c]));
    }
    const int level = own.level[c];
    const double side = own.domain.cell_side(level);
    const tree::GridCell at = tree::decode(tree::ancestor(own.corner[c], level));
    for (std::uint32_t p = own.first[c]; p < own.first[c + 1]; ++p) {
      const auto i = static_cast<std::size_t>(placed.id[p]);
      REQUIRE_FALSE(seen[i]);
      seen[i] = true;
      REQUIRE((placed.x[p] == points.x[i] && placed.y[p] == points.y[i]));
      REQUIRE(placed.reach[p] == reach[i]);
      if (level > 0) REQUIRE(side >= reach[i]);
      const double off = 1e-5 * side;
      REQUIRE(std::abs(points.x[i] - own.domain.x0 - (at.ix + 0.5) * side) <= 0.5 * side + off);
      REQUIRE(std::abs(points.y[i] - own.domain.y0 - (at.iy + 0.5) * side) <= 0.5 * side + off);
    }
  }
}

void check_deepest(const tree::HomeCells& own, const tree::SortedParticles& placed) {
  for (std::size_t c = 0; c < own.size(); ++c) {
    const double half = own.domain.cell_side(own.level[c]) / 2;
    for (std::uint32_t p = own.first[c]; p < own.first[c + 1]; ++p) {
      REQUIRE((own.level[c] == tree::kernel::deepest_own || half < 1.0001 * placed.reach[p]));
    }
  }
}

}  // namespace

TEST_CASE("every particle lies in its own cell, the deepest that spans its reach") {
  test::Chance chance(81);
  for (int round = 0; round < 200; ++round) {
    const test::Cloud cloud = test::any_cloud(400, chance);
    const int kind = chance.whole(0, test::reach_kinds - 1);
    const auto reach = test::make_reach(kind, cloud.x.size(), test::extent_of(cloud), chance);
    CAPTURE(round, cloud.name, kind);
    Cells cells;
    cells.own = tree::sort_into_own_cells(cloud.points(), reach, cells.placed);
    check_cells(cells, cloud.points(), reach);
    check_deepest(cells.own, cells.placed);
    const auto capacity = static_cast<std::uint32_t>(chance.whole(1, 30));
    const tree::Quadtree tree = tree::build_forward(
        tree::morton_order(cloud.points(), tree::enclose(cloud.points())), tree::crowded(capacity));
    cells.own = tree::sort_into_own_cells(tree, cloud.points(), reach, cells.placed);
    check_cells(cells, cloud.points(), reach);
  }
}

TEST_CASE("a cell of the tree of own cells splits if more than a few are inside and finer ones") {
  test::Chance chance(82);
  for (int round = 0; round < 100; ++round) {
    const test::Cloud cloud = test::any_cloud(300, chance);
    const auto reach = test::make_reach(chance.whole(0, 3), cloud.x.size(), 1.0, chance);
    tree::SortedParticles placed;
    const auto own = tree::sort_into_own_cells(cloud.points(), reach, placed);
    const auto few = static_cast<std::uint32_t>(chance.whole(0, 8));
    const tree::Quadtree tree = own.tree(few);
    for (const tree::Cell& cell : tree.cells()) {
      const auto [first, last] = cell.points;
      const int finest = *std::max_element(own.level.begin() + first, own.level.begin() + last);
      const bool must = finest > cell.level && own.first[last] - own.first[first] > few;
      REQUIRE(cell.childless() == !must);
    }
  }
}

TEST_CASE("addresses of own cells by registers equal those one by one, and can be taken apart") {
  test::Chance chance(83);
  for (int round = 0; round < 2000; ++round) {
    const auto n = static_cast<std::size_t>(chance.whole(1, 40));
    std::vector<double> reach(n);
    for (double& r : reach) {
      r = chance.whole(0, 9) == 0 ? 0 : std::ldexp(1 + chance.real(), chance.whole(-34, 3));
      if (chance.whole(0, 3) == 0) r = std::ldexp(1.0, chance.whole(-34, 3));
    }
    std::vector<tree::MortonKey> codes(n), plain;
    for (tree::MortonKey& code : codes) code = chance.bits() >> 2;
    plain = codes;
    const auto [least, most] = std::minmax_element(reach.begin(), reach.end());
    const tree::kernel::Addresses addresses{tree::kernel::own_level(1, *most),
                                            tree::kernel::own_level(1, *least)};
    tree::kernel::home_cells(addresses, 1, reach.data(), n, codes.data());
    for (std::size_t i = 0; i < n; ++i) {
      const int level = tree::kernel::own_level(1, reach[i]);
      REQUIRE((level == 0 || std::ldexp(1.0, -level) >= reach[i]));
      REQUIRE((level == tree::kernel::deepest_own || std::ldexp(1.0, -level - 1) < reach[i]));
      const int inside = 2 * (tree::max_level - level);
      REQUIRE(addresses.level(codes[i]) == level);
      REQUIRE(addresses.corner(codes[i]) == plain[i] >> inside << inside);
    }
    tree::kernel::plain_own_cells(addresses, 1, reach.data(), n, plain.data());
    REQUIRE(codes == plain);
  }
}

TEST_CASE("digit by digit, numbers are sorted by the bits asked for, and no others") {
  test::Chance chance(84);
  for (const std::size_t n : {0u, 1u, 2u, 100u, 5000u, 200000u}) {
    for (int round = 0; round < 6; ++round) {
      const int low = chance.whole(0, 40), high = chance.whole(low, 64);
      Unwritten<std::uint64_t> numbers(n);
      for (std::uint64_t& number : numbers) number = chance.bits() >> chance.whole(0, 8);
      const auto part = [&](std::uint64_t number) {
        return high == low ? 0 : number << (64 - high) >> (64 - high + low);
      };
      auto twin = numbers;
      std::stable_sort(twin.begin(), twin.end(),
                       [&](std::uint64_t a, std::uint64_t b) { return part(a) < part(b); });
      tree::digit_sort(numbers, low, high);
      REQUIRE(std::equal(numbers.begin(), numbers.end(), twin.begin()));
    }
  }
}
