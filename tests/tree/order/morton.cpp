#include "tree/order/morton.hpp"

#include <catch2/catch.hpp>

#include "tree/clouds.hpp"

using namespace vortree;

namespace {

// The definition, bit by bit.
tree::MortonKey plain_encode(tree::GridCell cell) {
  tree::MortonKey key = 0;
  for (int k = 0; k < 32; ++k) {
    key += (static_cast<tree::MortonKey>(cell.ix >> k & 1) +
            2 * static_cast<tree::MortonKey>(cell.iy >> k & 1))
           << 2 * k;
  }
  return key;
}

tree::GridCell plain_decode(tree::MortonKey key) {
  tree::GridCell cell;
  for (int k = 0; k < 32; ++k) {
    cell.ix += static_cast<std::uint32_t>(key >> 2 * k & 1) << k;
    cell.iy += static_cast<std::uint32_t>(key >> (2 * k + 1) & 1) << k;
  }
  return cell;
}

int plain_common_level(tree::MortonKey a, tree::MortonKey b) {
  int level = tree::max_level;
  while (tree::ancestor(a, level) != tree::ancestor(b, level)) {
    --level;
  }
  return level;
}

}  // namespace

TEST_CASE("interleaving by bit tricks equals interleaving bit by bit") {
  test::Chance chance(1);
  for (int i = 0; i < 20000; ++i) {
    const int drop = chance.whole(1, 31);
    const tree::GridCell cell{static_cast<std::uint32_t>(chance.bits()) >> drop,
                              static_cast<std::uint32_t>(chance.bits()) >> drop};
    REQUIRE(tree::encode(cell) == plain_encode(cell));
    REQUIRE(tree::decode(tree::encode(cell)) == cell);
    const tree::MortonKey key = chance.bits() >> 2;
    REQUIRE(tree::decode(key) == plain_decode(key));
  }
  for (const std::uint32_t last : {0u, 1u, 0x7fffffffu}) {
    CHECK(tree::encode({last, 0}) == plain_encode({last, 0}));
    CHECK(tree::encode({0, last}) == plain_encode({0, last}));
  }
}

TEST_CASE(
    "the four children of a cell follow it: lower left, lower right, upper left, upper right") {
  const tree::MortonKey parent = tree::encode({5, 9});
  CHECK(tree::decode(4 * parent) == tree::GridCell{10, 18});
  CHECK(tree::decode(4 * parent + 1) == tree::GridCell{11, 18});
  CHECK(tree::decode(4 * parent + 2) == tree::GridCell{10, 19});
  CHECK(tree::decode(4 * parent + 3) == tree::GridCell{11, 19});
}

TEST_CASE("two codes part at the level that their ancestors say") {
  test::Chance chance(2);
  for (int i = 0; i < 20000; ++i) {
    const tree::MortonKey a = chance.bits() >> 2;
    const tree::MortonKey b = a ^ (chance.bits() >> 2) >> chance.whole(0, 61);
    REQUIRE(tree::common_level(a, b) == plain_common_level(a, b));
  }
  CHECK(tree::common_level(7, 7) == tree::max_level);
  CHECK(tree::common_level(6, 7) == tree::max_level - 1);
  CHECK(tree::common_level(0, tree::first_descendant(3, 1)) == 0);
}

TEST_CASE("a cell holds the codes from its first descendant to the next cell's") {
  test::Chance chance(3);
  for (int level = 0; level <= tree::max_level; ++level) {
    const tree::MortonKey cell = level == 0 ? 0 : chance.bits() >> (64 - 2 * level);
    const tree::MortonKey first = tree::first_descendant(cell, level);
    const tree::MortonKey beyond = tree::first_descendant(cell + 1, level);
    CHECK(tree::ancestor(first, level) == cell);
    CHECK(tree::ancestor(beyond - 1, level) == cell);
    CHECK(tree::ancestor(beyond, level) == cell + 1);
  }
}
