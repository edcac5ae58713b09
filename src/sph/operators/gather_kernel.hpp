#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "tree/base/simd.hpp"

namespace vortree::sph {

/// Values of neighbors, a particle a lane.
inline Lanes gather(std::span<const double> of, const std::int32_t* index) {
  Lanes a;
  for (int lane = 0; lane < lane_count; ++lane) a[lane] = of[index[lane]];
  return a;
}

/// Values of a group's own particles; those beyond the last are the last.
inline Lanes own(std::span<const double> of, std::size_t from) {
  Lanes a;
  for (int lane = 0; lane < lane_count; ++lane) a[lane] = of[std::min(from + lane, of.size() - 1)];
  return a;
}

inline Lanes root(Lanes a) {
  for (int lane = 0; lane < lane_count; ++lane) a[lane] = __builtin_sqrt(a[lane]);
  return a;
}

}  // namespace vortree::sph
