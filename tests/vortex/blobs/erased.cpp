#include <catch2/catch.hpp>

#include "vortex/blobs/blobs.hpp"

using namespace vortree;
using namespace vortree::vortex;

namespace {

Blobs numbered(std::initializer_list<int> numbers) {
  Blobs blobs;
  for (const int n : numbers)
    blobs.append({1.0 * n, 2.0 * n}, 3.0 * n, Core{4.0 * n, {0.5 * n, 0.25 * n}});
  return blobs;
}

}  // namespace

TEST_CASE("blobs that are erased are gone in all columns, the others keep their order") {
  using Numbers = std::vector<std::uint32_t>;
  const auto without = [](const Numbers& numbers) {
    Blobs blobs = numbered({1, 2, 3, 4, 5});
    blobs.erase(numbers);
    return blobs;
  };
  CHECK(without({0}) == numbered({2, 3, 4, 5}));
  CHECK(without({4}) == numbered({1, 2, 3, 4}));
  CHECK(without({1, 2}) == numbered({1, 4, 5}));
  CHECK(without({0, 2, 4}) == numbered({2, 4}));
  CHECK(without({0, 1, 2, 3, 4}) == Blobs());
  CHECK(without({}) == numbered({1, 2, 3, 4, 5}));
}
