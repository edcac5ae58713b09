#pragma once

#include <cstdint>
#include <vector>

#include "tree/morton.hpp"

namespace vortree::tree {

/// Sorts keys ascending and carries the indices along; stable.
///
/// The 32 leading bits of those in which any two keys differ are sorted first, least significant
/// byte first; then, where keys still agree in all of them, the runs of such keys by the rest.
/// Bytes in which no two keys differ cost nothing.
///
/// cost    O(n): at most four passes over all pairs, and four more over those in long runs; 12
///         bytes an element of spare memory
/// throws  std::invalid_argument if the sizes differ
void radix_sort(std::vector<Key>& keys, std::vector<std::uint32_t>& index);

}  // namespace vortree::tree
