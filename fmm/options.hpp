#pragma once

#include <cstdint>

#include "fmm/geometry/arrangement.hpp"
#include "fmm/sources.hpp"
#include "tree/build/quadtree.hpp"

namespace vortree::fmm {

/// fmm     multipoles and local expansions: O(n)
/// boxes   multipoles straight to the targets: O(n log n); every source's core is guarded by itself
/// direct  every pair summed, to round-off: O(n^2); tolerance, order and tree do not matter
enum class SumMethod { fmm, boxes, direct };

/// tolerance      what the user is promised (Plan), in (0, 1)
/// order          terms of a series, 1 .. 200; 0: chosen by tolerance for every distance of cells.
///                A fixed order keeps no promise; cells then meet one cell apart
/// capacity       points of a childless cell at most; 0: chosen
/// finest_level   no cell lies below; 0 .. 31
struct Options {
  double tolerance = 1e-6;
  int order = 0;
  std::uint32_t capacity = 0;
  int finest_level = tree::max_level;
  Builder builder = Builder::reverse;
  Cores cores = Cores::source;
  SumMethod method = SumMethod::fmm;
};

/// Single precision is exact enough: its errors are a tenth of the tolerance.
[[nodiscard]] inline bool coarse(const Options& options) {
  return options.order == 0 && options.tolerance >= 1e-6;
}

/// Sums of doubles are as exact as so much of the norm of all sums of |contributions|: some
/// roundings, of 2^-53 each, of each of them.
inline constexpr double round_off = 0x1p-49;

/// Nothing is gained by asking for less.
inline constexpr double least_tolerance = 1e-16;

}  // namespace vortree::fmm
