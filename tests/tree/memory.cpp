#include "tree/memory.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstring>
#include <random>
#include <span>
#include <vector>

using namespace vortree;

namespace {

constexpr std::size_t least = kept_memory::least;

}  // namespace

TEST_CASE("blocks of kept memory never overlap, whatever was taken and given back before") {
  std::mt19937 random(1);
  std::vector<std::span<unsigned char>> blocks;
  for (int turn = 0; turn < 500; ++turn) {
    if (blocks.size() < 8 && random() % 3 != 0) {
      const std::size_t bytes = least + random() % (4 * least);
      const std::span block(static_cast<unsigned char*>(kept_memory::take(bytes)), bytes);
      std::memset(block.data(), static_cast<int>(random() % 256), bytes);
      blocks.push_back(block);
    } else if (!blocks.empty()) {
      std::swap(blocks[random() % blocks.size()], blocks.back());
      const auto block = blocks.back();
      REQUIRE(std::ranges::count(block, block[0]) == static_cast<std::ptrdiff_t>(block.size()));
      kept_memory::give_back(block.data());
      blocks.pop_back();
    }
  }
  for (const auto block : blocks) kept_memory::give_back(block.data());
}

TEST_CASE("a large block of memory serves small ones after it, and they it again") {
  kept_memory::release();
  const std::size_t before = kept_memory::idle();
  void* const large = kept_memory::take(8 * least);
  kept_memory::give_back(large);
  REQUIRE(kept_memory::idle() == before + 8 * least);
  void* const first = kept_memory::take(3 * least);
  void* const second = kept_memory::take(5 * least);
  CHECK(kept_memory::idle() == before);
  kept_memory::give_back(first);
  kept_memory::give_back(second);
  CHECK(kept_memory::take(8 * least) == large);
  kept_memory::give_back(large);
  kept_memory::release();
  CHECK(kept_memory::idle() == before);
}

TEST_CASE("no more memory is kept than was in use at a time, and an eighth") {
  kept_memory::release();
  const std::size_t before = kept_memory::idle();
  for (std::size_t size = 1; size <= 8; ++size)
    kept_memory::give_back(kept_memory::take(size * least));
  CHECK(kept_memory::idle() <= before + 9 * least);
  kept_memory::release();
}
