#include <omp.h>

#include <catch2/catch.hpp>
#include <limits>
#include <stdexcept>

#include "tree/build/assembly.hpp"
#include "tree/build/build_forward.hpp"
#include "tree/build/build_reverse.hpp"
#include "tree/build/laws.hpp"
#include "tree/build/rules.hpp"

using namespace vortree;
using tree::Block;
using tree::MortonOrder;
using tree::Quadtree;
using tree::Range;

namespace {

struct Leaf {
  tree::MortonKey key;
  int level;
  Range points;
  bool operator==(const Leaf&) const = default;
};

// The definition of the tree, by recursion and linear search: cell by cell, ask the rule, cut in
// four.
void plain_leaves(const MortonOrder& order, const tree::SplitRule& must_split, Leaf cell,
                  std::vector<Leaf>& leaves) {
  if (cell.points.empty()) return;
  const Block block{cell.level, std::ldexp(order.domain.side, -cell.level), cell.points};
  if (cell.level == order.finest || !must_split(block)) {
    leaves.push_back(cell);
    return;
  }
  std::uint32_t first = cell.points.first;
  for (tree::MortonKey q = 0; q < 4; ++q) {
    std::uint32_t last = first;
    while (last < cell.points.last &&
           tree::ancestor(order.keys[last], cell.level + 1) == 4 * cell.key + q) {
      ++last;
    }
    plain_leaves(order, must_split, {4 * cell.key + q, cell.level + 1, {first, last}}, leaves);
    first = last;
  }
}

std::vector<Leaf> plain_leaves(const MortonOrder& order, const tree::SplitRule& must_split) {
  std::vector<Leaf> leaves;
  plain_leaves(order, must_split, {0, 0, {0, static_cast<std::uint32_t>(order.keys.size())}},
               leaves);
  return leaves;
}

std::vector<Leaf> leaves_of(const Quadtree& tree) {
  std::vector<Leaf> leaves;
  for (const std::uint32_t c : tree.childless()) {
    const tree::Cell& cell = tree.cells()[c];
    leaves.push_back({cell.key, cell.level, cell.points});
  }
  return leaves;
}

// The claims of every builder, on one cloud and one rule.
void check_builders(const test::Cloud& cloud, const MortonOrder& order,
                    const tree::SplitRule& must_split) {
  const Quadtree forward = tree::build_forward(order, must_split);
  const Quadtree reverse = tree::build_reverse(order, must_split);
  REQUIRE(forward == reverse);
  REQUIRE(forward == Quadtree(order, {forward.cells().begin(), forward.cells().end()}));
  for (const std::size_t pieces : {2u, 5u, 40u}) {
    REQUIRE(tree::grow_forward(order, must_split, pieces).over(order) == forward);
    REQUIRE(tree::grow_reverse(order, must_split, pieces).over(order) == forward);
  }
  REQUIRE(test::broken_law(forward, must_split, cloud.points()) == "");
  REQUIRE(leaves_of(reverse) == plain_leaves(order, must_split));
}

}  // namespace

TEST_CASE("forward and reverse construction give the same tree, the one of the definition") {
  for (int seed = 0; seed < 10000; ++seed) {
    test::Chance chance(seed);
    const test::Cloud cloud = test::any_cloud(chance.whole(0, 9) == 0 ? 2000 : 120, chance);
    const int finest = chance.whole(0, 1) == 0 ? tree::max_level : chance.whole(0, tree::max_level);
    const MortonOrder order =
        tree::morton_order(cloud.points(), tree::enclose(cloud.points()), finest);
    const test::NamedRule rule = test::any_rule(order, chance);
    INFO(cloud.name << " of " << cloud.x.size() << ", " << rule.name << ", finest " << finest
                    << ", seed " << seed);
    check_builders(cloud, order, rule.must_split);
  }
}

TEST_CASE("every kind of cloud at every finest level and crowding keeps the laws") {
  test::Chance chance(31);
  for (int kind = 0; kind < test::cloud_kinds; ++kind) {
    const test::Cloud cloud = test::make_cloud(kind, 500, chance);
    for (int finest = 0; finest <= tree::max_level; ++finest) {
      const MortonOrder order =
          tree::morton_order(cloud.points(), tree::enclose(cloud.points()), finest);
      for (const std::uint32_t n_ctrl : {1u, 2u, 7u, 40u, 499u, 500u}) {
        INFO(cloud.name << ", finest " << finest << ", n_ctrl " << n_ctrl);
        check_builders(cloud, order, tree::crowded(n_ctrl));
      }
    }
  }
}

TEST_CASE("every crowding from 1 to 100 gives the same tree both ways") {
  test::Chance chance(32);
  const test::Cloud cloud = test::make_cloud(9, 1500, chance);
  const MortonOrder order = tree::morton_order(cloud.points(), tree::enclose(cloud.points()));
  for (std::uint32_t n_ctrl = 1; n_ctrl <= 100; ++n_ctrl) {
    check_builders(cloud, order, tree::crowded(n_ctrl));
  }
}

TEST_CASE("no points make no cells") {
  const MortonOrder none = tree::morton_order({}, tree::enclose({}));
  for (const Quadtree& tree :
       {tree::build_forward(none, tree::crowded(1)), tree::build_reverse(none, tree::crowded(1))}) {
    CHECK(tree.cells().empty());
    CHECK(tree.childless().empty());
    CHECK(tree.depth() == -1);
    CHECK(tree.level(0).empty());
  }
}

TEST_CASE("a lone point is a childless root; points at one place split down to the finest level") {
  const std::vector<double> one{3.0}, many(50, 3.0);
  for (const auto build : {tree::build_forward, tree::build_reverse}) {
    const Quadtree lone =
        build(tree::morton_order({one, one}, tree::enclose({one, one})), tree::crowded(1));
    CHECK(lone.cells().size() == 1);
    CHECK(lone.cells()[0].childless());
    for (const int finest : {0, 5, tree::max_level}) {
      const MortonOrder order =
          tree::morton_order({many, many}, tree::enclose({many, many}), finest);
      const Quadtree chain = build(order, tree::crowded(49));
      CHECK(chain.depth() == finest);
      CHECK(chain.cells().size() == static_cast<std::size_t>(finest) + 1);
      CHECK(build(order, tree::crowded(50)).cells().size() == 1);
    }
  }
}

TEST_CASE("a cell that splits under roomy is never too narrow for the smallest reach inside") {
  test::Chance chance(33);
  const test::Cloud cloud = test::make_cloud(0, 3000, chance);
  const MortonOrder order = tree::morton_order(cloud.points(), tree::enclose(cloud.points()));
  const std::vector<double> reach = test::random_reach(3000, order.domain.side / 4, chance);
  const Quadtree tree = tree::build_reverse(order, tree::roomy(reach));
  for (const std::uint32_t c : tree.childless()) {
    const tree::Cell& cell = tree.cells()[c];
    const double least =
        *std::min_element(reach.begin() + cell.points.first, reach.begin() + cell.points.last);
    CHECK(tree.side(cell.level) < 2 * least);
  }
}

TEST_CASE("clusters of 1e-14, offsets of 1e6 and sizes of 1e300 keep the laws") {
  test::Chance chance(34);
  for (const double away : {0.0, 0.5, 1e6}) {
    for (const double size : {1e-300, 1e-14, 1.0, 1e300}) {
      test::Cloud cloud = test::make_cloud(0, 400, chance);
      for (std::size_t i = 0; i < cloud.x.size(); ++i) {
        cloud.x[i] = cloud.x[i] * size + away;
        cloud.y[i] = cloud.y[i] * size - away;
      }
      const MortonOrder order = tree::morton_order(cloud.points(), tree::enclose(cloud.points()));
      INFO("size " << size << " at " << away);
      check_builders(cloud, order, tree::crowded(5));
    }
  }
}

TEST_CASE("neither builder asks about a block without points or at the finest level") {
  for (int seed = 0; seed < 200; ++seed) {
    test::Chance chance(seed);
    const test::Cloud cloud = test::any_cloud(200, chance);
    const int finest = chance.whole(0, 12);
    const MortonOrder order =
        tree::morton_order(cloud.points(), tree::enclose(cloud.points()), finest);
    const tree::SplitRule wary = [&](const Block& block) {
      REQUIRE_FALSE(block.points.empty());
      REQUIRE(block.points.last <= order.keys.size());
      REQUIRE(block.level < finest);
      REQUIRE(block.side == std::ldexp(order.domain.side, -block.level));
      return block.points.size() > 3;
    };
    CHECK(tree::build_forward(order, wary) == tree::build_reverse(order, wary));
  }
}

TEST_CASE(
    "the reverse builder asks a few questions for each childless cell, even down a chain of 31 "
    "levels") {
  test::Chance chance(35);
  for (int kind = 0; kind < test::cloud_kinds; ++kind) {
    const test::Cloud cloud = test::make_cloud(kind, 3000, chance);
    const MortonOrder order = tree::morton_order(cloud.points(), tree::enclose(cloud.points()));
    std::size_t questions = 0;
    const Quadtree tree = tree::build_reverse(order, [&](const Block& block) {
      ++questions;
      return block.points.size() > 10;
    });
    INFO(cloud.name);
    CHECK(questions <= 8 * tree.childless().size());
  }
}

TEST_CASE("large trees are the same for any number of threads") {
  const int threads = omp_get_max_threads();
  test::Chance chance(36);
  for (const int kind : {0, 1, 6, 9}) {
    const test::Cloud cloud = test::make_cloud(kind, 200000, chance);
    std::vector<Quadtree> trees;
    for (const int count : {1, 2, 3, 8}) {
      omp_set_num_threads(count);
      const MortonOrder order = tree::morton_order(cloud.points(), tree::enclose(cloud.points()));
      const tree::SplitRule own = [](const Block& block) { return block.points.size() > 20; };
      trees.push_back(tree::build_forward(order, tree::crowded(20)));
      trees.push_back(tree::build_reverse(order, tree::crowded(20)));
      trees.push_back(tree::build_forward(order, own));
      trees.push_back(tree::build_reverse(order, own));
    }
    for (const Quadtree& tree : trees) {
      INFO(cloud.name);
      REQUIRE(tree == trees[0]);
    }
    REQUIRE(test::broken_law(trees[0], tree::crowded(20), cloud.points()) == "");
  }
  omp_set_num_threads(threads);
}

TEST_CASE("what a rule throws comes out of a large tree, too") {
  const std::vector<double> reach(50, 1.0);
  test::Chance chance(37);
  const test::Cloud cloud = test::make_cloud(0, 200000, chance);
  const MortonOrder order = tree::morton_order(cloud.points(), tree::enclose(cloud.points()));
  for (const auto build : {tree::build_forward, tree::build_reverse}) {
    CHECK_THROWS_WITH(build(order, tree::roomy(reach)), Catch::Contains("only 50 reaches"));
  }
}

TEST_CASE("an empty rule is refused") {
  CHECK_THROWS_AS(tree::build_forward({}, tree::SplitRule{}), std::invalid_argument);
  CHECK_THROWS_AS(tree::build_reverse({}, tree::SplitRule{}), std::invalid_argument);
}

TEST_CASE("keys without their indices are refused") {
  const MortonOrder torn{{}, tree::max_level, {1, 2, 3}, {0, 1}};
  CHECK_THROWS_WITH(tree::build_forward(torn, tree::crowded(1)),
                    Catch::Contains("3 keys but 2 indices"));
  CHECK_THROWS_WITH(tree::build_reverse(torn, tree::crowded(1)),
                    Catch::Contains("3 keys but 2 indices"));
}
