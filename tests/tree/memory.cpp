#include "tree/memory.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
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
      // A block may be twice as large as what was asked for.
      CHECK(kept_memory::idle() <= 3 * most);
    }
  }
  kept_memory::release();
}
