#include "tree/build/split_rule.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "tree/build/rules.hpp"

using namespace vortree;
using Catch::Matchers::Contains;
using tree::Block;

TEST_CASE("a block is crowded when it holds more than n_ctrl points") {
  for (const std::uint32_t n : {1u, 2u, 40u, 100u}) {
    const tree::SplitRule crowded = tree::crowded(n);
    CHECK_FALSE(crowded(Block{3, 1.0, {10, 10 + n}}));
    CHECK(crowded(Block{3, 1.0, {10, 11 + n}}));
  }
}

TEST_CASE("a block is roomy when half its side spans the smallest reach inside") {
  test::Chance chance(21);
  for (const int n : {1, 2, 15, 16, 17, 255, 256, 257, 5000}) {
    const std::vector<double> reach = test::random_reach(n, 1.0, chance);
    const tree::SplitRule roomy = tree::roomy(reach);
    for (int i = 0; i < 2000; ++i) {
      const int a = chance.whole(0, n - 1), b = chance.whole(a + 1, n);
      const double least = *std::min_element(reach.begin() + a, reach.begin() + b);
      const tree::Range points{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)};
      REQUIRE(roomy(Block{0, 2 * least, points}));
      REQUIRE_FALSE(roomy(Block{0, 2 * least * (1 - 1e-15), points}));
    }
  }
}

TEST_CASE("one reach for all is the same as equal reaches") {
  const std::vector<double> reach(50, 0.01);
  const tree::SplitRule each = tree::roomy(reach), all = tree::roomy(0.01);
  for (const double side : {1.0, 0.02, 0.0199, 0.005}) {
    CHECK(each(Block{1, side, {3, 30}}) == all(Block{1, side, {3, 30}}));
  }
}

TEST_CASE("either splits when one rule says so, both when both do") {
  for (const bool a : {false, true}) {
    for (const bool b : {false, true}) {
      const auto says = [](bool answer) { return [answer](const Block&) { return answer; }; };
      CHECK(tree::either(says(a), says(b))(Block{}) == (a || b));
      CHECK(tree::both(says(a), says(b))(Block{}) == (a && b));
    }
  }
}

TEST_CASE("rules are monotone: inside a block that need not split, none must") {
  for (int seed = 0; seed < 300; ++seed) {
    test::Chance chance(seed);
    const std::uint32_t n = chance.whole(1, 300);
    const tree::MortonOrder order{{0, 0, 1},
                                  tree::max_level,
                                  Unwritten<tree::MortonKey>(n, 0),
                                  Unwritten<std::uint32_t>(n, 0)};
    const test::NamedRule rule = test::any_rule(order, chance);
    for (int i = 0; i < 300; ++i) {
      const std::uint32_t first = chance.whole(0, n - 1), last = chance.whole(first + 1, n);
      const std::uint32_t inner = chance.whole(first, last - 1),
                          end = chance.whole(inner + 1, last);
      const int level = chance.whole(0, 15), deeper = level + chance.whole(0, 15);
      const Block outside{level, std::ldexp(1.0, -level), {first, last}};
      const Block inside{deeper, std::ldexp(1.0, -deeper), {inner, end}};
      if (rule.must_split(inside)) {
        INFO(rule.name << ", seed " << seed);
        REQUIRE(rule.must_split(outside));
      }
    }
  }
}

TEST_CASE("senseless rules are refused with their numbers") {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(tree::crowded(0), Contains("n_ctrl is 0"));
  CHECK_THROWS_WITH(tree::roomy(-1.0), Contains("reach is -1"));
  CHECK_THROWS_AS(tree::roomy(nan), std::invalid_argument);
  for (const double bad : {-0.5, nan, inf}) {
    std::vector<double> reach(10, 0.1);
    reach[7] = bad;
    CHECK_THROWS_WITH(tree::roomy(reach), Contains("reach[7] is"));
  }
  CHECK_THROWS_WITH(tree::roomy(std::vector<double>(3, 0.1))(Block{0, 1, {0, 4}}),
                    Contains("ends at point 4") && Contains("only 3 reaches"));
  CHECK_THROWS_AS(tree::either({}, tree::crowded(1)), std::invalid_argument);
  CHECK_THROWS_AS(tree::both(tree::crowded(1), {}), std::invalid_argument);
}
