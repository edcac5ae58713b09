#pragma once

#include <cstdint>

namespace vortree {

/// splitmix64 (Steele, Lea & Flood 2014): every input bit reaches every output bit.
constexpr std::uint64_t splitmix64(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

}  // namespace vortree
