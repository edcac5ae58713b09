#include "tree/base/memory.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <span>
#include <vector>

using namespace vortree;

namespace {

constexpr std::size_t mebibyte = 1u << 20;

/// What a step of some calculation asks for: two blocks that stay, one in passing, one after it.
std::vector<void*> step() {
  std::vector<void*> stay{kept_memory::take(9 * mebibyte), kept_memory::take(3 * mebibyte)};
  void* passing = kept_memory::take(32 * mebibyte);
  kept_memory::give_back(passing);
  stay.push_back(kept_memory::take(7 * mebibyte));
  for (void* memory : stay) kept_memory::give_back(memory);
  stay.push_back(passing);
  return stay;
}

}  // namespace

TEST_CASE("from the second step on memory is that of the step before") {
  kept_memory::release();
  const auto first = step();
  const std::size_t idle = kept_memory::idle();
  CHECK(idle >= 44 * mebibyte);
  for (int round = 0; round < 3; ++round) {
    CHECK(step() == first);
    CHECK(kept_memory::idle() == idle);
  }
  kept_memory::release();
  CHECK(kept_memory::idle() == 0);
}

TEST_CASE("small blocks lie together, apart from each other, and are those of the step before") {
  kept_memory::release();
  const auto small_step = [] {
    std::vector<void*> blocks;
    for (std::size_t k = 0; k < 40; ++k)
      blocks.push_back(kept_memory::take(kept_memory::least + 1000 * k));
    for (std::size_t k = 0; k < 40; ++k)
      std::memset(blocks[k], static_cast<int>(k), kept_memory::least + 1000 * k);
    for (std::size_t k = 0; k < 40; ++k) {
      const auto* first = static_cast<const unsigned char*>(blocks[k]);
      CHECK(reinterpret_cast<std::uintptr_t>(first) % 64 == 0);
      CHECK(std::count(first, first + kept_memory::least + 1000 * k, k) ==
            static_cast<std::ptrdiff_t>(kept_memory::least + 1000 * k));
    }
    for (void* memory : blocks) kept_memory::give_back(memory);
    return blocks;
  };
  const auto first = small_step();
  CHECK(kept_memory::idle() == 2 * mebibyte);
  CHECK(small_step() == first);
  kept_memory::release();
  CHECK(kept_memory::idle() == 0);
}

TEST_CASE("blocks of kept memory never overlap, whatever was taken and given back before") {
  std::mt19937 random(1);
  std::vector<std::span<unsigned char>> blocks;
  for (int turn = 0; turn < 500; ++turn) {
    if (blocks.size() < 8 && random() % 3 != 0) {
      const std::size_t most = random() % 2 == 0 ? 4 * mebibyte : mebibyte / 8;
      const std::size_t bytes = kept_memory::least + random() % most;
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
  void* const large = kept_memory::take(8 * mebibyte);
  kept_memory::give_back(large);
  REQUIRE(kept_memory::idle() == before + 8 * mebibyte);
  void* const first = kept_memory::take(3 * mebibyte);
  void* const second = kept_memory::take(5 * mebibyte);
  CHECK(kept_memory::idle() == before);
  kept_memory::give_back(first);
  kept_memory::give_back(second);
  CHECK(kept_memory::take(8 * mebibyte) == large);
  kept_memory::give_back(large);
  kept_memory::release();
  CHECK(kept_memory::idle() == before);
}

TEST_CASE("no more memory is kept than half as much again as was once in use") {
  kept_memory::release();
  std::vector<void*> blocks;
  std::size_t used = 0, most = 0;
  for (std::size_t round = 0; round < 200; ++round) {
    const std::size_t bytes = (1 + round * 37 % 29) * mebibyte;
    blocks.push_back(kept_memory::take(bytes));
    used += bytes;
    most = std::max(most, used);
    if (blocks.size() == 5) {
      for (void* memory : blocks) kept_memory::give_back(memory);
      blocks.clear();
      used = 0;
      CHECK(kept_memory::idle() <= most / 2 * 3);
    }
  }
  kept_memory::release();
}
