#include "tree/neighbors/candidate_kernel.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tree/clouds.hpp"

using namespace vortree;
using namespace vortree::tree;

TEST_CASE("the chosen lanes are stored close, for every set of lanes") {
  test::Chance chance(41);
  std::vector<float> from(single_count), to(single_count);
  std::vector<std::int32_t> numbers(single_count), close(single_count);
  for (int i = 0; i < single_count; ++i) from[i] = 0.5f + (numbers[i] = 10 + i);
  for (int round = 0; round < 3000; ++round) {
    const auto lanes = static_cast<kernel::Hits>(chance.bits() & kernel::every_lane);
    kernel::store_close(to.data(), load(from.data()), lanes);
    kernel::store_close(close.data(), load(numbers.data()), lanes);
    for (int i = 0, next = 0; i < single_count; ++i) {
      if ((lanes >> i & 1) == 0) continue;
      REQUIRE(to[next] == from[i]);
      REQUIRE(close[next++] == numbers[i]);
    }
  }
}

TEST_CASE("a register of floats is compared, clipped and made as each of its lanes") {
  test::Chance chance(42);
  for (int round = 0; round < 300; ++round) {
    std::vector<double> wide(single_count);
    std::vector<float> a(single_count), b(single_count);
    for (int i = 0; i < single_count; ++i) {
      wide[i] = chance.real() * 100;
      a[i] = static_cast<float>(chance.whole(-3, 3)),
      b[i] = static_cast<float>(chance.whole(-3, 3));
    }
    const Singles va = load(a.data()), vb = load(b.data());
    const Singles made = kernel::near_floats(wide.data(), 50.0, 0.25);
    const Singles low = smaller(va, vb), high = larger(va, vb);
    const Singles size = magnitude(va);
    const unsigned below = kernel::less(va, vb);
    for (int i = 0; i < single_count; ++i) {
      REQUIRE(made[i] == static_cast<float>((wide[i] - 50.0) * 0.25));
      REQUIRE(low[i] == std::min(a[i], b[i]));
      REQUIRE(high[i] == std::max(a[i], b[i]));
      REQUIRE(size[i] == std::abs(a[i]));
      REQUIRE((below >> i & 1u) == (a[i] < b[i]));
    }
  }
}

TEST_CASE("the first lanes are as many as there are numbers left") {
  for (std::size_t n = 0; n < 2 * single_count; ++n) {
    CHECK(std::popcount(kernel::first_singles(n)) ==
          static_cast<int>(std::min<std::size_t>(n, single_count)));
  }
}

TEST_CASE("a copy ends where it should") {
  std::vector<std::int32_t> from(200), to(200);
  for (int i = 0; i < 200; ++i) from[i] = i;
  for (std::size_t n = 0; n < 100; ++n) {
    to.assign(200, -1);
    kernel::copy_exactly(from.data(), n, to.data());
    for (std::size_t i = 0; i < 200; ++i) REQUIRE(to[i] == (i < n ? from[i] : -1));
  }
}

namespace {

template <PairRule rule>
void check_tests(test::Chance& chance) {
  constexpr std::size_t registers = 9, n = registers * single_count;
  std::vector<float> u(n), v(n), term(n);
  for (std::size_t k = 0; k < n; ++k) {
    u[k] = static_cast<float>(chance.real()), v[k] = static_cast<float>(chance.real());
    term[k] = kernel::reach_term<rule>(static_cast<float>(0.7 * chance.real()));
  }
  const float reach = 0.4f;
  std::vector<kernel::Hits> hits(registers - 1);
  const auto tested = kernel::test<rule>({u.data(), v.data(), term.data()}, 1, registers, 0.5f,
                                         0.5f, kernel::reach_term<rule>(reach), 1e-6f, hits.data());
  CHECK(tested.sure);
  std::int64_t count = 0;
  for (std::size_t k = single_count; k < n; ++k) {
    const double other = rule == PairRule::mean ? 2.0 * term[k] : std::sqrt(term[k]);
    const double r = pair_reach<rule>(reach, other);
    const bool inside = std::hypot(u[k] - 0.5, v[k] - 0.5) < r;
    CHECK((hits[k / single_count - 1] >> k % single_count & 1) == inside);
    count += inside;
  }
  CHECK(tested.hits == count);
}

}  // namespace

TEST_CASE("many at once pass the test that each passes alone") {
  test::Chance chance(43);
  for (int round = 0; round < 20; ++round) {
    check_tests<PairRule::max>(chance);
    check_tests<PairRule::mean>(chance);
    check_tests<PairRule::own>(chance);
  }
}

TEST_CASE("who is too near to the threshold for floats is told") {
  std::vector<float> u(single_count, 5.0f), v(single_count, 0.0f), term(single_count, 1.0f);
  kernel::Hits hits = 0;
  const auto sure = [&](float at) {
    u[1] = at;
    return kernel::test<PairRule::max>({u.data(), v.data(), term.data()}, 0, 1, 0.0f, 0.0f, 1.0f,
                                       1e-7f, &hits)
        .sure;
  };
  CHECK(sure(0.99f));
  CHECK(sure(1.01f));
  CHECK_FALSE(sure(1.0f));
  CHECK_FALSE(sure(std::nextafter(1.0f, 2.0f)));
  CHECK_FALSE(sure(std::nextafter(1.0f, 0.0f)));
}
