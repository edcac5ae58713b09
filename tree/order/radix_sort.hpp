#pragma once

#include <cstdint>
#include <span>

#include "tree/base/memory.hpp"
#include "tree/order/morton.hpp"

namespace vortree::tree {

/// Sorts keys ascending; stable. Returns where each was before.
///
/// Keys are parted by the highest bits in which any two differ, at most 10, into buckets that
/// threads share. A bucket that is not yet right for the cache (RunSort) is parted again: a crowd
/// by keys picked from it, so that it is spread however narrow it is, others by the next eight bits
/// that differ in them; if it is large, by all threads.
///
/// cost    O(n): keys are moved once through memory and sorted in the cache, those of crowds once
/// or
///         twice more; 16 bytes a key of spare memory
/// threads OpenMP; the result is the same for any number
[[nodiscard]] Unwritten<std::uint32_t> radix_sort(std::span<MortonKey> keys);

/// The same, carrying an index along.
///
/// throws  std::invalid_argument if the sizes differ
void radix_sort(std::span<MortonKey> keys, std::span<std::uint32_t> index);

}  // namespace vortree::tree
