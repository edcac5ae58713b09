#include "tree/neighbors/candidate_kernel.hpp"

#include <array>
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

TEST_CASE("numbers that were hit stand one after the other, for any number of registers") {
  test::Chance chance(44);
  std::vector<std::int32_t> index(9 * single_count), to(10 * single_count);
  for (std::size_t k = 0; k < index.size(); ++k) index[k] = static_cast<std::int32_t>(k);
  for (std::size_t registers = 0; registers < 10; ++registers) {
    std::vector<kernel::Hits> hits(registers);
    std::vector<std::int32_t> hit;
    for (std::size_t k = 0; k < registers * single_count; ++k) {
      if (chance.whole(0, 1) == 0) continue;
      hits[k / single_count] |= static_cast<kernel::Hits>(1u << k % single_count);
      hit.push_back(index[k]);
    }
    std::int32_t* const end = kernel::expand(hits.data(), registers, index.data(), to.data());
    CHECK(std::vector<std::int32_t>(to.data(), end) == hit);
  }
}

namespace {

template <PairRule rule, std::size_t count>
void check_tests(test::Chance& chance) {
  constexpr std::size_t registers = 9, n = registers * single_count;
  std::vector<float> u(n), v(n), term(n);
  for (std::size_t k = 0; k < n; ++k) {
    u[k] = static_cast<float>(chance.real()), v[k] = static_cast<float>(chance.real());
    term[k] = kernel::reach_term<rule>(static_cast<float>(0.7 * chance.real()));
  }
  std::array<kernel::Seeker, count> seekers;
  for (std::size_t s = 0; s < count; ++s) {
    const float reach = 0.4f + 0.1f * static_cast<float>(s);
    seekers[s] = {0.5f, 0.3f + 0.2f * static_cast<float>(s), kernel::reach_term<rule>(reach)};
  }
  std::vector<kernel::Hits> hits(count * (registers - 1));
  const auto tested = kernel::test<rule, count>({u.data(), v.data(), term.data()}, 1, registers,
                                                seekers, 1e-6f, hits.data());
  CHECK(tested.sure);
  for (std::size_t s = 0; s < count; ++s) {
    std::int64_t passed = 0;
    for (std::size_t k = single_count; k < n; ++k) {
      const double other = rule == PairRule::mean ? 2.0 * term[k] : std::sqrt(term[k]);
      const double r = pair_reach<rule>(0.4 + 0.1 * static_cast<double>(s), other);
      const bool inside = std::hypot(u[k] - seekers[s].u, v[k] - seekers[s].v) < r;
      const kernel::Hits set = hits[s * (registers - 1) + k / single_count - 1];
      CHECK((set >> k % single_count & 1) == inside);
      passed += inside;
    }
    CHECK(tested.hits[s] == passed);
  }
}

}  // namespace

TEST_CASE("many at once pass the test that each passes alone") {
  test::Chance chance(43);
  for (int round = 0; round < 20; ++round) {
    check_tests<PairRule::max, 1>(chance);
    check_tests<PairRule::max, 2>(chance);
    check_tests<PairRule::mean, 1>(chance);
    check_tests<PairRule::mean, 2>(chance);
    check_tests<PairRule::own, 1>(chance);
    check_tests<PairRule::own, 2>(chance);
  }
}

TEST_CASE("who is too near to the threshold for floats is told") {
  std::vector<float> u(single_count, 5.0f), v(single_count, 0.0f), term(single_count, 1.0f);
  kernel::Hits hits = 0;
  const auto sure = [&](float at) {
    u[1] = at;
    const std::array<kernel::Seeker, 1> seeker{{{0.0f, 0.0f, 1.0f}}};
    return kernel::test<PairRule::max, 1>({u.data(), v.data(), term.data()}, 0, 1, seeker, 1e-7f,
                                          &hits)
        .sure;
  };
  CHECK(sure(0.99f));
  CHECK(sure(1.01f));
  CHECK_FALSE(sure(1.0f));
  CHECK_FALSE(sure(std::nextafter(1.0f, 2.0f)));
  CHECK_FALSE(sure(std::nextafter(1.0f, 0.0f)));
}
