#pragma once

#include <bit>
#include <cstdint>

#include "tree/order/morton_kernel.hpp"

namespace vortree::tree {

/// A Morton code: the bits of a cell's column ix and row iy, interleaved, x lowest,
///
///   key = sum_k 4^k (bit_k(ix) + 2 bit_k(iy)),   0 <= ix, iy < 2^level.
///
/// A cell of level l has 2l bits. Dropping the last two gives its parent; its children are
/// 4 key + {0, 1, 2, 3}: lower left, lower right, upper left, upper right.
/// Within codes of level L, the descendants of (key, l) are [key 4^(L-l), (key + 1) 4^(L-l)).
///
/// source  Huang, Huang, Xu & Hu, Thermal Science 16 (2012), steps 5-7, corrected: the family
///         of four at level m starts at F + {0, 1, 2, 3} 4^(L-m), F a multiple of 4^(L-m+1)
using MortonKey = std::uint64_t;

/// The finest level there is: 2 * 31 bits fit a MortonKey.
inline constexpr int max_level = 31;

/// Column and row of a cell within its level.
struct GridCell {
  std::uint32_t ix = 0, iy = 0;
  bool operator==(const GridCell&) const = default;
};

[[nodiscard]] constexpr MortonKey encode(GridCell cell) {
  return kernel::spread_bits(cell.ix) | kernel::spread_bits(cell.iy) << 1;
}

[[nodiscard]] constexpr GridCell decode(MortonKey key) {
  return {kernel::gather_bits(key), kernel::gather_bits(key >> 1)};
}

/// The code of the cell of a level that holds the level-31 cell `finest`.
[[nodiscard]] constexpr MortonKey ancestor(MortonKey finest, int level) {
  return finest >> 2 * (max_level - level);
}

/// The first level-31 code inside the cell (key, level); key may be one past the last of its level.
[[nodiscard]] constexpr MortonKey first_descendant(MortonKey key, int level) {
  return key << 2 * (max_level - level);
}

/// The level of the smallest cell that holds both level-31 codes; 31 if they are equal.
[[nodiscard]] constexpr int common_level(MortonKey a, MortonKey b) {
  // Two unused bits lead every 62-bit code.
  return (std::countl_zero((a ^ b) | 1) - 2 + static_cast<int>(a == b)) / 2;
}

}  // namespace vortree::tree
