#pragma once

#include <cstdint>
#include <span>

#include "tree/order/morton.hpp"
#include "tree/order/points.hpp"

/// Searches in ascending codes, without branches to mispredict; their plain twin is
/// std::lower_bound.
namespace vortree::tree::kernel {

/// The first position in `within` whose key is not less than `bound`; within.last if there is none.
[[nodiscard]] inline std::uint32_t lower_bound(std::span<const MortonKey> keys, Range within,
                                               MortonKey bound) {
  const MortonKey* base = keys.data() + within.first;
  std::uint32_t size = within.size();
  while (size > 0) {
    const std::uint32_t half = (size + 1) / 2;
    base += base[half - 1] < bound ? half : 0;
    size -= half;
  }
  return static_cast<std::uint32_t>(base - keys.data());
}

/// The same from `from` to the end of the keys, in O(log distance): steps double until one is past.
[[nodiscard]] inline std::uint32_t gallop(std::span<const MortonKey> keys, std::uint32_t from,
                                          MortonKey bound) {
  const std::size_t n = keys.size();
  std::size_t low = from, step = 16;
  while (low + step < n && keys[low + step] < bound) {
    low += step;
    step *= 2;
  }
  const auto last = static_cast<std::uint32_t>(low + step < n ? low + step : n);
  return lower_bound(keys, {static_cast<std::uint32_t>(low), last}, bound);
}

}  // namespace vortree::tree::kernel
