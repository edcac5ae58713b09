#include "flow/columns.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "flow/solver.hpp"

using namespace vortree;
using Catch::Matchers::Contains;

TEST_CASE("columns are looked through before they are written, and found by name") {
  const flow::Columns good{{"x", "L", {1, 2}}, {"y", "L", {3, 4}}, {"u", "L/T", {5, 6}}};
  CHECK(flow::not_finite(good, "blob") == "");
  CHECK(flow::column(good, "u") == std::vector<double>{5, 6});
  CHECK_THROWS_WITH(flow::column(good, "v"), "no column v");
  for (std::size_t which = 0; which < good.size(); ++which) {
    flow::Columns bad = good;
    bad[which].values[1] = INFINITY;
    CHECK_THAT(flow::not_finite(bad, "blob"),
               Contains(good[which].name + " of blob 1 of 2 is inf"));
    bad[which].values[1] = NAN;
    CHECK_THAT(flow::not_finite(bad, "drop"), Contains("of drop 1 of 2 is nan"));
  }
}

TEST_CASE("what is missing from a saved state is named") {
  const flow::State state{{"one", {1}}, {"two", {1, 2}}};
  CHECK(flow::saved_number(state, "one") == 1);
  CHECK(flow::saved(state, "two").size() == 2);
  CHECK_THROWS_WITH(flow::saved(state, "three"), Contains("three"));
  CHECK_THROWS_WITH(flow::saved_number(state, "two"), Contains("two has 2 values"));
}
