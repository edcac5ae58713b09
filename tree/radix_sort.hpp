#pragma once

#include <cstdint>
#include <vector>

#include "tree/morton.hpp"

namespace vortree::tree {

/// Sorts keys ascending and carries the indices along; stable.
///
/// Many pairs are first parted by the highest byte in which any two keys differ; threads share the
/// buckets. In each, as many of the leading bits that differ as will tell most keys apart are
/// sorted, least significant byte first; then the runs of keys that still agree, in the same way.
/// Bytes in which no two keys differ cost nothing.
///
/// cost    O(n): four or five passes over all pairs, as many over those in long runs; 12 bytes an
///         element of spare memory
/// throws  std::invalid_argument if the sizes differ
void radix_sort(std::vector<Key>& keys, std::vector<std::uint32_t>& index);

}  // namespace vortree::tree
