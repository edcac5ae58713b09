#include "tree/build/colleagues.hpp"

#include <catch2/catch.hpp>

#include "tree/build/build_reverse.hpp"
#include "tree/build/split_rule.hpp"
#include "tree/clouds.hpp"

using namespace vortree;

TEST_CASE("colleagues are the cells of the same level around a cell") {
  test::Chance chance(51);
  for (int round = 0; round < 30; ++round) {
    const test::Cloud cloud = test::any_cloud(300, chance);
    const tree::Domain domain = tree::enclose(cloud.points());
    const auto tree =
        tree::build_reverse(tree::morton_order(cloud.points(), domain, 12),
                            tree::crowded(static_cast<std::uint32_t>(chance.whole(1, 9))));
    std::vector<tree::Colleagues> colleagues;
    tree::find_colleagues(tree, colleagues);
    REQUIRE(colleagues.size() == tree.cells().size());
    for (std::size_t a = 0; a < colleagues.size(); ++a) {
      tree::Colleagues expected;
      expected.fill(-1);
      const tree::GridCell here = tree::decode(tree.cells()[a].key);
      const tree::Range level = tree.level(tree.cells()[a].level);
      for (std::uint32_t b = level.first; b < level.last; ++b) {
        const tree::GridCell there = tree::decode(tree.cells()[b].key);
        const auto dx = static_cast<std::int64_t>(there.ix) - here.ix;
        const auto dy = static_cast<std::int64_t>(there.iy) - here.iy;
        if (std::abs(dx) <= 1 && std::abs(dy) <= 1) {
          expected[static_cast<std::size_t>(4 + dx + 3 * dy)] = static_cast<std::int32_t>(b);
        }
      }
      REQUIRE(colleagues[a] == expected);
    }
  }
}
