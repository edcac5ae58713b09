#include "tree/sort.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <numeric>

#include "tree/clouds.hpp"
#include "tree/radix_sort.hpp"

using namespace vortree;
using Catch::Matchers::Contains;

namespace {

struct Pairs {
  std::vector<tree::Key> keys;
  std::vector<std::uint32_t> index;
};

Pairs random_pairs(int n, tree::Key mask, test::Chance& chance) {
  Pairs pairs;
  for (int i = 0; i < n; ++i) {
    pairs.keys.push_back(chance.bits() & mask);
    pairs.index.push_back(static_cast<std::uint32_t>(i));
  }
  return pairs;
}

Pairs plainly_sorted(const Pairs& pairs) {
  Pairs sorted = pairs;
  std::stable_sort(sorted.index.begin(), sorted.index.end(),
                   [&](auto a, auto b) { return pairs.keys[a] < pairs.keys[b]; });
  std::stable_sort(sorted.keys.begin(), sorted.keys.end());
  return sorted;
}

// Column or row by its definition, in extended precision.
std::uint32_t plain_cell(double v, double origin, double side, int finest) {
  const long double cells = std::floor((static_cast<long double>(v) - origin) / side * 0x1p31L);
  const auto cell = static_cast<std::uint32_t>(std::min(cells, 0x1p31L - 1));
  return cell >> (tree::max_level - finest) << (tree::max_level - finest);
}

}  // namespace

TEST_CASE("radix sort equals std::stable_sort") {
  test::Chance chance(11);
  const tree::Key all = ~tree::Key{0};
  for (const tree::Key mask : {all, all >> 2, tree::Key{0}, tree::Key{1}, tree::Key{0xff00},
                               tree::Key{0xf00000000000000f}, tree::Key{7} << 61, tree::Key{0x3ff},
                               tree::Key{0x3000000000003fff}, tree::Key{0xffff00000000}}) {
    for (const int n : {0, 1, 2, 3, 10, 63, 64, 65, 255, 1000, 5000}) {
      Pairs pairs = random_pairs(n, mask, chance);
      const Pairs expected = plainly_sorted(pairs);
      tree::radix_sort(pairs.keys, pairs.index);
      INFO("mask " << mask << ", n " << n);
      REQUIRE(pairs.keys == expected.keys);
      REQUIRE(pairs.index == expected.index);
    }
  }
}

TEST_CASE("radix sort refuses keys and indices of different number") {
  std::vector<tree::Key> keys(3);
  std::vector<std::uint32_t> index(2);
  CHECK_THROWS_WITH(tree::radix_sort(keys, index), Contains("3 keys but 2 indices"));
}

TEST_CASE("points come in the order of their codes, equal ones in the order of input") {
  for (int seed = 0; seed < 400; ++seed) {
    test::Chance chance(seed);
    const test::Cloud cloud = test::any_cloud(300, chance);
    const int finest = chance.whole(0, tree::max_level);
    const tree::MortonOrder order =
        tree::morton_order(cloud.points(), tree::enclose(cloud.points()), finest);
    INFO(cloud.name << ", seed " << seed << ", finest " << finest);
    REQUIRE(order.finest == finest);
    REQUIRE(order.keys.size() == cloud.x.size());
    for (std::size_t j = 1; j < order.keys.size(); ++j) {
      REQUIRE(order.keys[j - 1] <= order.keys[j]);
      if (order.keys[j - 1] == order.keys[j]) REQUIRE(order.index[j - 1] < order.index[j]);
    }
    std::vector<std::uint32_t> permutation = order.index;
    std::sort(permutation.begin(), permutation.end());
    for (std::uint32_t i = 0; i < permutation.size(); ++i) REQUIRE(permutation[i] == i);
  }
}

TEST_CASE("codes are those of the definition wherever rounding cannot matter") {
  // Coordinates that are whole multiples of 2^-24 make every step exact.
  test::Chance chance(12);
  test::Cloud cloud;
  for (int i = 0; i < 2000; ++i) {
    cloud.add(chance.whole(-(1 << 24), 1 << 24) * 0x1p-24,
              chance.whole(-(1 << 24), 1 << 24) * 0x1p-24);
  }
  cloud.add(-1, -1);
  cloud.add(1, 1);
  const tree::Domain domain{-1, -1, 2};
  for (int finest = 0; finest <= tree::max_level; ++finest) {
    const tree::MortonOrder order = tree::morton_order(cloud.points(), domain, finest);
    for (std::size_t j = 0; j < order.keys.size(); ++j) {
      const std::uint32_t i = order.index[j];
      REQUIRE(tree::decode(order.keys[j]) == tree::GridCell{plain_cell(cloud.x[i], -1, 2, finest),
                                                            plain_cell(cloud.y[i], -1, 2, finest)});
    }
  }
}

TEST_CASE("the top and right edges belong to the last cells") {
  const std::vector<double> x{0.4, 0.1, 0.4}, y{0.4, 0.4, 0.1};
  const tree::MortonOrder order = tree::morton_order({x, y}, {0.1, 0.1, 0.3});
  const std::uint32_t last = (1u << 31) - 1;
  CHECK(order.index == std::vector<std::uint32_t>{2, 1, 0});
  CHECK(tree::decode(order.keys[0]) == tree::GridCell{last, 0});
  CHECK(tree::decode(order.keys[2]) == tree::GridCell{last, last});
}

TEST_CASE("columns grow with x, however the domain lies") {
  test::Chance chance(13);
  const double ulp = std::numeric_limits<double>::epsilon();
  for (const double origin : {0.0, 1.0, -1e6, 1e-9, 1e9}) {
    test::Cloud cloud;
    double x = origin;
    for (int i = 0; i < 3000; ++i) {
      cloud.add(x, 0);
      x += std::max(std::abs(x), 1e-9) * ulp * chance.whole(0, 3);
    }
    const tree::MortonOrder order =
        tree::morton_order(cloud.points(), tree::enclose(cloud.points()));
    for (std::size_t j = 0; j < order.index.size(); ++j) REQUIRE(order.index[j] == j);
  }
}

TEST_CASE("a point outside the domain is refused by its index") {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  for (const double bad : {-0.001, 1.001, nan, inf, -inf}) {
    for (const bool in_x : {true, false}) {
      std::vector<double> x(20, 0.5), y(20, 0.5);
      (in_x ? x : y)[17] = bad;
      CHECK_THROWS_AS(tree::morton_order({x, y}, {0, 0, 1}), std::invalid_argument);
      CHECK_THROWS_WITH(tree::morton_order({x, y}, {0, 0, 1}), Contains("point 17 at ("));
    }
  }
}

TEST_CASE("a senseless request for an order is refused with its numbers") {
  const std::vector<double> two{0.5, 0.5}, one{0.5};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(tree::morton_order({two, one}, {}), Contains("2 x but 1 y"));
  CHECK_THROWS_WITH(tree::morton_order({two, two}, {}, 32), Contains("finest level is 32"));
  CHECK_THROWS_WITH(tree::morton_order({two, two}, {}, -1), Contains("finest level is -1"));
  CHECK_THROWS_WITH(tree::morton_order({two, two}, {0, 0, 0}), Contains("of side 0"));
  CHECK_THROWS_WITH(tree::morton_order({two, two}, {0, 0, -1}), Contains("of side -1"));
  CHECK_THROWS_AS(tree::morton_order({two, two}, {0, 0, nan}), std::invalid_argument);
  CHECK_THROWS_AS(tree::morton_order({two, two}, {nan, 0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(tree::morton_order({two, two}, {0, 0, 1e-300}), std::invalid_argument);
}
