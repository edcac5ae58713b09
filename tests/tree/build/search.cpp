#include <algorithm>
#include <catch2/catch.hpp>

#include "tree/build/search_kernel.hpp"
#include "tree/clouds.hpp"

using namespace vortree;

TEST_CASE("searches without branches equal std::lower_bound") {
  test::Chance chance(51);
  for (int i = 0; i < 3000; ++i) {
    const int n = chance.whole(0, 300), span = chance.whole(1, 400);
    std::vector<tree::MortonKey> keys(n);
    for (tree::MortonKey& key : keys) key = chance.whole(0, span);
    std::sort(keys.begin(), keys.end());
    const int first = chance.whole(0, n), last = chance.whole(first, n);
    const tree::MortonKey bound = chance.whole(0, span + 1);
    const auto plain = [&](int from, int to) {
      return std::lower_bound(keys.begin() + from, keys.begin() + to, bound) - keys.begin();
    };
    const tree::Range within{static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last)};
    REQUIRE(tree::kernel::lower_bound(keys, within, bound) == plain(first, last));
    REQUIRE(tree::kernel::gallop(keys, within.first, bound) == plain(first, n));
  }
}
