#include "tree/build/quadtree.hpp"

#include <catch2/catch.hpp>
#include <functional>

#include "tree/build/build_forward.hpp"
#include "tree/build/laws.hpp"

using namespace vortree;
using tree::Cell;
using tree::Quadtree;

namespace {

// Five points; the lower left quarter is split once more.
struct Sample {
  std::vector<double> x{0.05, 0.3, 0.1, 0.9, 0.6}, y{0.05, 0.1, 0.4, 0.1, 0.7};
  tree::MortonOrder order = tree::morton_order({x, y}, {0, 0, 1});
  Quadtree tree = tree::build_forward(order, tree::crowded(1));
  [[nodiscard]] std::vector<Cell> cells() const {
    return {tree.cells().begin(), tree.cells().end()};
  }
};

}  // namespace

TEST_CASE("a small tree, cell by cell") {
  const Sample sample;
  const std::vector<Cell> expected{{0, 0, -1, {1, 4}, {0, 5}}, {0, 1, 0, {4, 7}, {0, 3}},
                                   {1, 1, 0, {}, {3, 4}},      {3, 1, 0, {}, {4, 5}},
                                   {0, 2, 1, {}, {0, 1}},      {1, 2, 1, {}, {1, 2}},
                                   {2, 2, 1, {}, {2, 3}}};
  CHECK(sample.cells() == expected);
  CHECK(sample.tree.depth() == 2);
  CHECK(sample.tree.level(1) == tree::Range{1, 4});
  CHECK(sample.tree.level(3).empty());
  CHECK(sample.tree.level(-1).empty());
  const std::vector<std::uint32_t> childless(sample.tree.childless().begin(),
                                             sample.tree.childless().end());
  CHECK(childless == std::vector<std::uint32_t>{4, 5, 6, 2, 3});
  CHECK(sample.tree.side(2) == 0.25);
  CHECK(sample.tree.centre(expected[5]) == tree::Centre{0.375, 0.125});
  CHECK(sample.tree.centre(expected[3]) == tree::Centre{0.75, 0.75});
}

TEST_CASE("trees are equal only if their points are") {
  const Sample sample;
  Sample other;
  CHECK(sample.tree == other.tree);
  other.y[4] = 0.70001;
  const auto order = tree::morton_order({other.x, other.y}, {0, 0, 1});
  CHECK_FALSE(sample.tree == tree::build_forward(order, tree::crowded(1)));
  CHECK_FALSE(sample.tree == tree::build_forward(sample.order, tree::crowded(3)));
}

TEST_CASE("cells that do not make a tree are refused") {
  const Sample sample;
  const std::vector<std::function<void(std::vector<Cell>&)>> harms{
      [](auto& c) { c.clear(); },
      [](auto& c) { c.pop_back(); },
      [](auto& c) { c.push_back(c.back()); },
      [](auto& c) { c[0].points.last = 4; },
      [](auto& c) { c[0].children.last = 3; },
      [](auto& c) { c[0].children.last = 90; },
      [](auto& c) { c[1].children = {}; },
      [](auto& c) { c[2].key = 2; },
      [](auto& c) { c[2].level = 2; },
      [](auto& c) { c[3].parent = 1; },
      [](auto& c) {
        c[3].points = {3, 5};
      },
      [](auto& c) {
        c[3].points = {5, 5};
      },
      [](auto& c) { std::swap(c[4], c[5]); },
      [](auto& c) { c[6].points.last = 4; }};
  CHECK(Quadtree(sample.order, sample.cells()) == sample.tree);
  for (std::size_t i = 0; i < harms.size(); ++i) {
    std::vector<Cell> cells = sample.cells();
    harms[i](cells);
    INFO("harm " << i);
    CHECK_THROWS_WITH(Quadtree(sample.order, cells), Catch::Contains("breaks the tree"));
  }
}

TEST_CASE("the laws notice a tree that another rule has made") {
  const Sample sample;
  const tree::Points points{sample.x, sample.y};
  CHECK(test::broken_law(sample.tree, tree::crowded(1), points) == "");
  CHECK(test::broken_law(sample.tree, tree::crowded(3), points) ==
        "every cell with children had to split");
  CHECK(test::broken_law(sample.tree, tree::roomy(0.01), points) ==
        "a childless cell obeys the rule");
  std::vector<double> moved = sample.x;
  moved[0] = 0.95;
  CHECK(test::broken_law(sample.tree, tree::crowded(1), {moved, sample.y}) ==
        "points lie in their cells");
}
