#include "bench/rivals/neighbors/cell_lists.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace vortree;

TEST_CASE("lists by cells are those of the naive search, in two and three dimensions") {
  for (const int dimensions : {2, 3}) {
    for (const std::size_t n : {0, 1, 2, 50, 1000}) {
      for (const double reach : {0.0, 0.01, 0.1, 0.5, 2.0}) {
        CAPTURE(dimensions, n, reach);
        const auto points = bench::random_coordinates(dimensions, n);
        auto naive = bench::neighbors_naive(points, reach);
        auto cells = bench::neighbors_by_cells(points, reach);
        for (auto* lists : {&naive, &cells}) {
          for (auto& list : *lists) std::ranges::sort(list);
        }
        REQUIRE(naive == cells);
      }
    }
  }
}
