#include "tree/build/adjacency.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tree/build/build_reverse.hpp"
#include "tree/clouds.hpp"

using namespace vortree;
using tree::Cell;

namespace {

Cell cell_at(std::uint32_t ix, std::uint32_t iy, int level) {
  return {tree::encode({ix, iy}), level, -1, {}, {}};
}

// By geometry: in a unit square, corners of cells down to level 31 are exact in double.
bool plainly_adjacent(const Cell& a, const Cell& b) {
  const auto low = [](std::uint32_t i, int level) { return std::ldexp(i, -level); };
  const auto touch = [&](std::uint32_t i, std::uint32_t j) {
    const double gap = std::max(low(i, a.level) - low(j, b.level) - std::ldexp(1, -b.level),
                                low(j, b.level) - low(i, a.level) - std::ldexp(1, -a.level));
    return gap <= 0;
  };
  const tree::GridCell ga = tree::decode(a.key), gb = tree::decode(b.key);
  return touch(ga.ix, gb.ix) && touch(ga.iy, gb.iy);
}

}  // namespace

TEST_CASE("adjacency is that of the closed squares, for any pair of levels") {
  test::Chance chance(41);
  int touching = 0;
  for (int i = 0; i < 200000; ++i) {
    const int level = chance.whole(0, tree::max_level), other = chance.whole(0, tree::max_level);
    const double x = chance.real(), y = chance.real();
    const auto cell = [&](double px, double py, int l) {
      const double side = std::ldexp(1, -l), last = std::ldexp(1, l) - 1;
      return cell_at(static_cast<std::uint32_t>(std::clamp(px / side, 0.0, last)),
                     static_cast<std::uint32_t>(std::clamp(py / side, 0.0, last)), l);
    };
    // Close enough that about half of the pairs touch.
    const double near =
        std::ldexp(1, -std::min(level, other)) + std::ldexp(1, -std::max(level, other));
    const Cell a = cell(x, y, level);
    const Cell b = cell(x + near * chance.whole(-1, 1), y + near * chance.whole(-1, 1), other);
    REQUIRE(tree::adjacent(a, b) == plainly_adjacent(a, b));
    REQUIRE(tree::adjacent(b, a) == tree::adjacent(a, b));
    touching += tree::adjacent(a, b);
  }
  CHECK(touching > 20000);
  CHECK(touching < 180000);
}

TEST_CASE("corners and edges touch, a cell apart does not") {
  CHECK(tree::adjacent(cell_at(3, 3, 4), cell_at(4, 4, 4)));
  CHECK(tree::adjacent(cell_at(3, 3, 4), cell_at(3, 4, 4)));
  CHECK_FALSE(tree::adjacent(cell_at(3, 3, 4), cell_at(5, 3, 4)));
  CHECK(tree::adjacent(cell_at(0, 0, 1), cell_at(1u << 30, 1u << 30, 31)));
  CHECK_FALSE(tree::adjacent(cell_at(0, 0, 1), cell_at((1u << 30) + 1, 0, 31)));
}

TEST_CASE("a cell is adjacent to itself, its ancestors and its descendants") {
  test::Chance chance(42);
  const test::Cloud cloud = test::make_cloud(9, 500, chance);
  const auto tree = tree::build_reverse(
      tree::morton_order(cloud.points(), tree::enclose(cloud.points())), tree::crowded(3));
  for (const Cell& cell : tree.cells()) {
    for (const Cell* up = &cell;; up = &tree.cells()[up->parent]) {
      REQUIRE(tree::adjacent(cell, *up));
      REQUIRE(tree::adjacent(*up, cell));
      if (up->parent < 0) break;
    }
  }
}
