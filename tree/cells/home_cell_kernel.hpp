#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "tree/base/simd.hpp"
#include "tree/order/morton.hpp"

/// Own cells of many particles, a register full at a time; the plain twin is the form for one.
namespace vortree::tree::kernel {

/// Finer own cells there are none: with its level, the corner of one fits 63 bits.
inline constexpr int deepest_own = 29;

/// The deepest level whose cells span a reach, in a domain of a given side.
[[nodiscard]] inline int own_level(double side, double reach) {
  const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(side / reach) >> 52) - 1023;
  return std::clamp(exponent, 0, deepest_own);
}

/// Cells of the levels coarsest..finest, each by its lower left corner and its level in one number:
///
///   address = (level-`finest` code of the corner) 2^level_bits + level - coarsest
///
/// Cells are ordered as their corners are, those on one corner the coarse before the fine: a cell
/// comes just before all that are inside it.
struct Addresses {
  int coarsest = 0, finest = deepest_own;

  [[nodiscard]] int level_bits() const {
    return std::bit_width(static_cast<unsigned>(finest - coarsest));
  }
  [[nodiscard]] int bits() const { return 2 * finest + level_bits(); }

  /// Of the cell of a level that holds a level-31 code.
  [[nodiscard]] MortonKey of(MortonKey code, int level) const {
    const int inside = 2 * (max_level - level), below = 2 * (max_level - finest);
    return (code >> inside << inside) >> below << level_bits() |
           static_cast<MortonKey>(level - coarsest);
  }
  /// Level-31 code of its corner.
  [[nodiscard]] MortonKey corner(MortonKey address) const {
    return address >> level_bits() << 2 * (max_level - finest);
  }
  [[nodiscard]] int level(MortonKey address) const {
    return coarsest + static_cast<int>(address & ((MortonKey{1} << level_bits()) - 1));
  }
};

/// Replaces the level-31 codes of n particles by the addresses of their own cells.
inline void plain_own_cells(const Addresses& addresses, double side, const double* reach,
                            std::size_t n, MortonKey* codes) {
  for (std::size_t i = 0; i < n; ++i) {
    codes[i] = addresses.of(codes[i], own_level(side, reach[i]));
  }
}

inline void home_cells(const Addresses& addresses, double side, const double* reach, std::size_t n,
                       MortonKey* codes) {
  using Words [[gnu::vector_size(register_bytes)]] = std::uint64_t;
  const int below = 2 * (max_level - addresses.finest), level_bits = addresses.level_bits();
  std::size_t i = 0;
  for (; i + lane_count <= n; i += lane_count) {
    const Lanes cells = side / load(reach + i);
    Bits level = (Bits)((Words)cells >> 52) - 1023;
    level = level > 0 ? level : Bits{};
    level = level < deepest_own ? level : Bits{} + deepest_own;
    const Words inside = (Words)(2 * (max_level - level));
    Words code;
    std::memcpy(&code, codes + i, sizeof code);
    code = (code >> inside << inside) >> below << level_bits | (Words)(level - addresses.coarsest);
    std::memcpy(codes + i, &code, sizeof code);
  }
  plain_own_cells(addresses, side, reach + i, n - i, codes + i);
}

}  // namespace vortree::tree::kernel
