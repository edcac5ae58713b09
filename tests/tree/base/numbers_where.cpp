#include "tree/base/numbers_where.hpp"

#include <omp.h>

#include <catch2/catch.hpp>

using namespace vortree::tree;

TEST_CASE("all numbers that something holds for are named, in order, by any number of threads") {
  const auto holds = [](std::uint32_t i) { return (i * 2654435761u >> 7) % 3 == 0; };
  const int most = omp_get_max_threads();
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{17},
                              records_worth_sharing + 1, 3 * records_worth_sharing}) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < n; ++i)
      if (holds(i)) expected.push_back(i);
    for (const int threads : {1, 2, 3}) {
      omp_set_num_threads(threads);
      CAPTURE(n, threads);
      CHECK(numbers_where(n, holds) == expected);
    }
  }
  omp_set_num_threads(most);
  CHECK(numbers_where(100, [](std::uint32_t) { return false; }).empty());
}
