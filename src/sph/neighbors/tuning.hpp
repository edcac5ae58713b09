#pragma once

#include <cstddef>

// Numbers of this room that were chosen by measurement.

namespace vortree::sph {

/// For more particles than this a kept list is made anew: each is held against all others, and so
/// many cost as much as a whole search.
inline constexpr std::size_t most_sought = 64;

}  // namespace vortree::sph
