#include "bench/measures/neighbor_measure.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace vortree;

TEST_CASE("the exponent of a power of n is found, from ten thousand on") {
  std::vector<bench::NeighborCost> costs{{1000, 7}, {3000, 1}};
  for (const double n : {1e4, 1e5, 1e6}) costs.push_back({n, 3e-7 * std::pow(n, 1.04)});
  const auto slope = bench::fit_slope(costs);
  REQUIRE(slope);
  CHECK(slope->exponent == Approx(1.04));
  CHECK(slope->from == 1e4);
  CHECK(slope->to == 1e6);
  costs.pop_back();
  CHECK_FALSE(bench::fit_slope(costs));
}
