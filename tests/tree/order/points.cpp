#include "tree/order/points.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tree/build/extent_kernel.hpp"
#include "tree/clouds.hpp"

using namespace vortree;
using Catch::Matchers::Contains;

namespace {

tree::Domain enclose(const std::vector<double>& x, const std::vector<double>& y) {
  return tree::enclose({x, y});
}

bool has_20_bits(double v) {
  int exponent;
  const double significand = std::ldexp(std::frexp(v, &exponent), 20);
  return significand == std::floor(significand);
}

}  // namespace

TEST_CASE("the domain is the smallest square around the points, at most 2^-18 too wide") {
  for (int seed = 0; seed < 300; ++seed) {
    test::Chance chance(seed);
    const test::Cloud cloud = test::make_cloud(chance.whole(0, 5), chance.whole(2, 200), chance);
    const tree::Domain domain = tree::enclose(cloud.points());
    double low_x = cloud.x[0], high_x = low_x, low_y = cloud.y[0], high_y = low_y;
    for (std::size_t i = 0; i < cloud.x.size(); ++i) {
      low_x = std::min(low_x, cloud.x[i]), high_x = std::max(high_x, cloud.x[i]);
      low_y = std::min(low_y, cloud.y[i]), high_y = std::max(high_y, cloud.y[i]);
    }
    const double width = std::max(high_x - low_x, high_y - low_y);
    CAPTURE(cloud.name, seed, width);
    REQUIRE(domain.x0 == low_x);
    REQUIRE(domain.y0 == low_y);
    REQUIRE(domain.side > width * (1 + 0x1p-21));
    REQUIRE(domain.side < width * (1 + 0x1p-18));
    REQUIRE(has_20_bits(domain.side));
  }
}

TEST_CASE(
    "a single place gets a domain in which the finest cell is as wide as the spacing of doubles") {
  for (const double far : {1e-200, 1e-14, 1.0, 3.0, 1e6, 1e300}) {
    for (const std::size_t n : {1u, 7u}) {
      const tree::Domain domain =
          enclose(std::vector<double>(n, -far), std::vector<double>(n, far / 3));
      CAPTURE(far, n, domain.side);
      CHECK(domain.side * 0x1p-31 >= std::nextafter(far, 2 * far) - far);
      CHECK(domain.side <= far * 0x1p-20);
    }
  }
}

TEST_CASE("the extent by whole numbers equals that by comparing doubles") {
  test::Chance chance(61);
  for (int n = 1; n < 200; ++n) {
    std::vector<double> values(n);
    for (double& v : values) {
      v = (chance.real() - 0.5) * std::pow(10.0, chance.whole(-320, 308));
      REQUIRE(tree::kernel::from_ordinal(tree::kernel::ordinal(v)) == v);
    }
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    REQUIRE(tree::kernel::extent(values).low == *low);
    REQUIRE(tree::kernel::extent(values).high == *high);
  }
}

TEST_CASE("no points, or points at the origin only, get the unit square") {
  CHECK(enclose({}, {}) == tree::Domain{0, 0, 1});
  CHECK(enclose({0, 0}, {0, -0.0}) == tree::Domain{0, 0, 1});
}

TEST_CASE("extreme coordinates give a finite domain") {
  CHECK(enclose({-1e300, 1e300}, {0, 1}).side == Approx(2e300));
  CHECK(enclose({-1e307, 1e307}, {-1e307, 1e307}).side == Approx(2e307));
  CHECK(enclose({0, 5e-324}, {0, 0}).side >= 0x1p-900);
  CHECK(enclose({1e6, 1e6 + 1}, {1e6, 1e6}).side == Approx(1));
  CHECK(enclose({0.5, 0.5 + 1e-14}, {0, 0}).side == Approx(0.5 * 0x1p-21));
  CHECK(enclose({0, 1e-14}, {0, 0}).side == Approx(1e-14));
}

TEST_CASE("a coordinate that is not a number is refused by name and index") {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, 1.7e308, -1.7e308}) {
    for (const std::size_t n : {1u, 3u, 8u, 37u}) {
      std::vector<double> good(n, 0.25), spoilt = good;
      spoilt[n - 1] = bad;
      CHECK_THROWS_AS(enclose(spoilt, good), std::invalid_argument);
      CHECK_THROWS_WITH(enclose(spoilt, good), Contains("x[" + std::to_string(n - 1) + "] is"));
      CHECK_THROWS_WITH(enclose(good, spoilt), Contains("y[" + std::to_string(n - 1) + "] is"));
    }
  }
  std::vector<double> x(40, 1.0);
  x[9] = x[22] = nan;
  CHECK_THROWS_WITH(enclose(x, x), Contains("x[9]"));
}

TEST_CASE("different numbers of x and y are refused") {
  CHECK_THROWS_WITH(enclose({1, 2, 3}, {1, 2}), Contains("3 x but 2 y"));
}
