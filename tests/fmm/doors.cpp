#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "fmm/direct.hpp"
#include "fmm/plan.hpp"

using namespace vortree;
using Catch::Matchers::Contains;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
const std::vector<double> three{1, 2, 3}, two{1, 2};

void make(const std::vector<double>& x, const std::vector<double>& y,
          const std::vector<double>& gamma, const std::vector<double>& sigma,
          fmm::Options options = {}) {
  fmm::Plan plan({x, y, gamma, sigma}, options);
}

}  // namespace

TEST_CASE("blobs that cannot be summed are refused by name, index and value") {
  CHECK_THROWS_WITH(make(three, two, three, {}), Contains("y has 2 values, x has 3"));
  CHECK_THROWS_WITH(make(three, three, two, {}), Contains("gamma has 2 values, x has 3"));
  CHECK_THROWS_WITH(make(three, three, three, two), Contains("sigma has 2 values, x has 3"));
  CHECK_THROWS_WITH(make({1, no_number, 3}, three, three, {}), Contains("x[1] is nan"));
  CHECK_THROWS_WITH(make(three, {1, 2, -inf}, three, {}), Contains("y[2] is -inf"));
  CHECK_THROWS_WITH(make(three, three, {inf, 2, 3}, {}), Contains("gamma[0] is inf"));
  CHECK_THROWS_WITH(make(three, three, three, {1, -0.5, 3}), Contains("sigma[1] is -0.5"));
  CHECK_THROWS_AS(make(three, three, three, {1, no_number, 3}), std::invalid_argument);
}

TEST_CASE("options out of range are refused with their value") {
  CHECK_THROWS_WITH(make(three, three, three, {}, {.tolerance = 0}), Contains("tolerance is 0"));
  CHECK_THROWS_WITH(make(three, three, three, {}, {.tolerance = 1}), Contains("tolerance is 1"));
  CHECK_THROWS_AS(make(three, three, three, {}, {.tolerance = no_number}), std::invalid_argument);
  CHECK_THROWS_WITH(make(three, three, three, {}, {.order = -1}), Contains("order is -1"));
  CHECK_THROWS_WITH(make(three, three, three, {}, {.order = 201}), Contains("order is 201"));
  CHECK_THROWS_WITH(make(three, three, three, {}, {.finest_level = 32}),
                    Contains("finest_level is 32"));
}

TEST_CASE("targets and results that do not fit are refused") {
  const fmm::Blobs blobs{three, three, three, {}};
  const fmm::Plan plan(blobs, {});
  std::vector<double> u(3), v(3), few(2);
  CHECK_THROWS_WITH(plan.velocity(few, v), Contains("u has 2 values and v 3; both must have 3"));
  CHECK_THROWS_WITH(plan.velocity({three, two, {}}, u, v), Contains("y has 2 values, x has 3"));
  CHECK_THROWS_WITH(plan.velocity({three, three, two}, u, v), Contains("sigma has 2"));
  CHECK_THROWS_WITH(plan.velocity({two, two, {}}, u, v), Contains("both must have 2"));
  const std::vector<double> broken{1, no_number, 3};
  CHECK_THROWS_WITH(plan.velocity_bare({broken, three}, u, v), Contains("x[1] is nan"));
  CHECK_THROWS_WITH(fmm::velocity_direct(blobs, {three, broken, {}}, fmm::Cores::source, u, v),
                    Contains("y[1] is nan"));
  CHECK_THROWS_WITH(fmm::velocity_direct(blobs, {three, three, {}}, fmm::Cores::mean, few, v),
                    Contains("u has 2 values"));
}
