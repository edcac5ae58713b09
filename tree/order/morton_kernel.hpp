#pragma once

#include <cstdint>

/// Bit tricks of the Morton code; their plain twins stand in tests/tree/order/morton.cpp.
namespace vortree::tree::kernel {

/// Moves bit k of a 32-bit number to bit 2k.
[[nodiscard]] constexpr std::uint64_t spread_bits(std::uint32_t number) {
  std::uint64_t v = number;
  v = (v | v << 16) & 0x0000ffff0000ffff;
  v = (v | v << 8) & 0x00ff00ff00ff00ff;
  v = (v | v << 4) & 0x0f0f0f0f0f0f0f0f;
  v = (v | v << 2) & 0x3333333333333333;
  v = (v | v << 1) & 0x5555555555555555;
  return v;
}

/// Moves bit 2k of a 64-bit number to bit k and drops the odd bits.
[[nodiscard]] constexpr std::uint32_t gather_bits(std::uint64_t code) {
  std::uint64_t v = code & 0x5555555555555555;
  v = (v | v >> 1) & 0x3333333333333333;
  v = (v | v >> 2) & 0x0f0f0f0f0f0f0f0f;
  v = (v | v >> 4) & 0x00ff00ff00ff00ff;
  v = (v | v >> 8) & 0x0000ffff0000ffff;
  v = (v | v >> 16) & 0x00000000ffffffff;
  return static_cast<std::uint32_t>(v);
}

}  // namespace vortree::tree::kernel
