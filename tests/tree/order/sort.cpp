#include "tree/order/sort.hpp"

#include <omp.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <numeric>

#include "tree/clouds.hpp"
#include "tree/order/encode_kernel.hpp"
#include "tree/order/radix_sort.hpp"
#include "tree/order/run_sort.hpp"

using namespace vortree;
using Catch::Matchers::Contains;

namespace {

struct Pairs {
  std::vector<tree::MortonKey> keys;
  std::vector<std::uint32_t> index;
};

Pairs random_pairs(int n, tree::MortonKey mask, test::Chance& chance) {
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
  const tree::MortonKey all = ~tree::MortonKey{0};
  for (const tree::MortonKey mask :
       {all, all >> 2, tree::MortonKey{0}, tree::MortonKey{1}, tree::MortonKey{0xff00},
        tree::MortonKey{0xf00000000000000f}, tree::MortonKey{7} << 61, tree::MortonKey{0x3ff},
        tree::MortonKey{0x3000000000003fff}, tree::MortonKey{0xffff00000000}}) {
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

TEST_CASE("many keys, spread or in crowds, are sorted by any number of threads") {
  test::Chance chance(14);
  const int threads = omp_get_max_threads();
  for (const int n : {30000, 149000, 200000}) {
    Pairs pairs = random_pairs(n, ~tree::MortonKey{0} >> 2, chance);
    for (std::size_t i = 0; i < pairs.keys.size(); ++i) {
      // a third spread, a third closing in on one key, a third in few bits far down
      if (i % 3 == 1) pairs.keys[i] >>= chance.whole(0, 61);
      if (i % 3 == 2) pairs.keys[i] = pairs.keys[i] % 5000 + 0x3000000000000000;
    }
    const Pairs expected = plainly_sorted(pairs);
    for (const int count : {1, 2, 5}) {
      omp_set_num_threads(count);
      Pairs sorted = pairs;
      tree::radix_sort(sorted.keys, sorted.index);
      REQUIRE(sorted.keys == expected.keys);
      REQUIRE(sorted.index == expected.index);
      sorted = pairs;
      REQUIRE(std::ranges::equal(tree::radix_sort(sorted.keys), expected.index));
      REQUIRE(sorted.keys == expected.keys);
    }
  }
  omp_set_num_threads(threads);
}

TEST_CASE("a run is sorted in the cache as std::stable_sort would, whatever its bits") {
  test::Chance chance(15);
  tree::RunSort sort;
  for (int seed = 0; seed < 2000; ++seed) {
    const std::size_t n = chance.whole(1, seed % 100 == 0 ? 9000 : 300);
    const int bits = chance.whole(0, tree::RunSort::most_bits(n));
    const tree::MortonKey shared = chance.bits();
    std::vector<tree::Record> run(n);
    tree::MortonKey differing = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const tree::MortonKey low = bits == 0 ? 0 : chance.bits() >> (64 - bits);
      const tree::MortonKey crowd = chance.whole(0, 1) == 0 ? low : low >> (bits - bits / 2);
      run[i] = {bits == 64 ? crowd : (shared >> bits << bits) | crowd,
                static_cast<std::uint32_t>(chance.whole(0, 1000000))};
      differing |= run[i].key ^ run[0].key;
    }
    std::vector<tree::MortonKey> keys(n);
    std::vector<std::uint32_t> index(n);
    sort(run, differing, keys, index);
    std::stable_sort(run.begin(), run.end(), [](auto& a, auto& b) { return a.key < b.key; });
    INFO("seed " << seed << ", n " << n << ", bits " << bits);
    for (std::size_t i = 0; i < n; ++i) {
      REQUIRE(keys[i] == run[i].key);
      REQUIRE(index[i] == run[i].index);
    }
  }
}

TEST_CASE("crowds of equal keys among others, of the greatest key, and of two keys are sorted") {
  test::Chance chance(17);
  const int threads = omp_get_max_threads();
  const tree::MortonKey last = ~tree::MortonKey{0};
  for (const int kind : {0, 1, 2, 3}) {
    Pairs pairs = random_pairs(260000, last, chance);
    for (std::size_t i = 0; i < pairs.keys.size(); ++i) {
      tree::MortonKey& key = pairs.keys[i];
      const bool rare = i % 4999 == 17;
      if (kind == 0 && !rare) key = 42;
      if (kind == 1 && !rare) key = last;
      if (kind == 2) key = last - key % 2;
      if (kind == 3) key = rare ? 0x1000000000000001 : 0x1000000000000000;
    }
    const Pairs expected = plainly_sorted(pairs);
    for (const int count : {1, 3}) {
      omp_set_num_threads(count);
      Pairs sorted = pairs;
      tree::radix_sort(sorted.keys, sorted.index);
      REQUIRE(sorted.keys == expected.keys);
      REQUIRE(sorted.index == expected.index);
    }
  }
  omp_set_num_threads(threads);
}

TEST_CASE("a short run is sorted by all bits, equal keys in their order") {
  test::Chance chance(18);
  tree::RunSort sort_run;
  for (const tree::MortonKey mask :
       {~tree::MortonKey{0} >> 2, tree::MortonKey{0}, tree::MortonKey{7}, tree::MortonKey{7} << 59,
        tree::MortonKey{0x3000000000000003}}) {
    for (const int n : {1, 2, 24, 25, 85, 300, 512}) {
      Pairs pairs = random_pairs(n, mask, chance);
      const Pairs expected = plainly_sorted(pairs);
      sort_run.whole(pairs.keys, pairs.index);
      REQUIRE(pairs.keys == expected.keys);
      REQUIRE(pairs.index == expected.index);
    }
  }
}

TEST_CASE("codes of many points at once are those of one after the other") {
  test::Chance chance(16);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::size_t n : {0u, 1u, 3u, 4u, 7u, 8u, 9u, 100u, 1003u}) {
    std::vector<double> x(n), y(n);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] = 1.2 * chance.real() - 0.1;
      y[i] = chance.whole(0, 9) == 0 ? nan : chance.real();
    }
    if (n > 3) x[1] = 1.0, y[1] = 0.0, x[2] = 1e300, y[3] = -1e300;
    const tree::kernel::DomainAxis axis{0.0, 1.0, 0x1p31};
    const tree::MortonKey mask = ~tree::MortonKey{0} << 2 * chance.whole(0, 31);
    std::vector<tree::MortonKey> fast(n), plain(n);
    const std::size_t strays =
        tree::kernel::plain_codes(x.data(), y.data(), n, axis, axis, mask, plain.data());
    CHECK(tree::kernel::codes(x.data(), y.data(), n, axis, axis, mask, fast.data()) == strays);
    CHECK(fast == plain);
  }
}

TEST_CASE("radix sort refuses keys and indices of different number") {
  std::vector<tree::MortonKey> keys(3);
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
    auto permutation = order.index;
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
  CHECK(order.index == Unwritten<std::uint32_t>{2, 1, 0});
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
