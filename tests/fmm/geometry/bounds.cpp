#include "fmm/geometry/bounds.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "fmm/geometry/bounds_kernel.hpp"

using namespace vortree::fmm;

namespace {

void check_same(const Bounds& a, const Bounds& b) {
  CHECK(a.low == b.low);
  CHECK(a.high == b.high);
  CHECK(a.least_magnitude == b.least_magnitude);
  CHECK(a.all_numbers == b.all_numbers);
}

}  // namespace

TEST_CASE("bounds by lanes are those found one by one, strange values among them") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double strange[] = {0.0, -0.0, NAN, -NAN, infinity, -infinity, 5e-324, -1e308};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> even(-1, 1);
  for (int round = 0; round < 400; ++round) {
    std::vector<double> values(random() % 40);
    for (double& value : values) value = std::ldexp(even(random), static_cast<int>(random() % 60));
    for (std::size_t k = random() % 3; k > 0 && !values.empty(); --k) {
      values[random() % values.size()] = strange[random() % std::size(strange)];
    }
    CAPTURE(round, values.size());
    check_same(kernel::bounds(values), kernel::plain_bounds(values));
  }
}

TEST_CASE("the bounds of many values do not miss those where threads part") {
  const std::size_t n = 200001;
  std::vector<double> values(n, 1.0);
  for (std::size_t p = 0; p <= 16; ++p) {
    for (const std::size_t i : {n * p / 16, n * p / 16 - 1}) {
      if (i >= n) continue;
      values[i] = -2.0;
      CHECK(bounds_of(values).low == -2.0);
      values[i] = NAN;
      CHECK(!bounds_of(values).all_numbers);
      CHECK(!bounds_of(values).within(-3.0, 3.0));
      values[i] = 1.0;
    }
  }
  CHECK(bounds_of(values).half_width() == 0.0);
  CHECK(bounds_of({}).within(0.0, 0.0));
  CHECK(bounds_of({}).largest_magnitude() == 0.0);
  CHECK(bounds_of({}).half_width() == 0.0);
}
