#pragma once

#include "fmm/geometry/units.hpp"
#include "fmm/sources.hpp"
#include "tree/base/memory.hpp"

namespace vortree::fmm {

/// A blob in Units; core is sigma squared. All of it lies in one line of the cache: taken in the
/// order of a tree, each comes from anywhere.
struct alignas(32) Vortex {
  double x, y, gamma, core;
};

/// The blobs side by side, in input order.
///
/// cost   O(n), 32 bytes a blob
[[nodiscard]] Unwritten<Vortex> side_by_side(const Sources& sources, const Units& units);

}  // namespace vortree::fmm
