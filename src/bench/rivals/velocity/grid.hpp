#pragma once

#include <cstddef>
#include <span>

#include "fmm/sources.hpp"
#include "tree/base/phase.hpp"

namespace vortree::bench {

/// tolerance   in (0, 1)
/// most_bytes  of memory; a grid that needs more is refused
/// measured    time the transforms before the first use of a size, up to a second: pays when many
///             sums follow in one process
struct GridOptions {
  double tolerance = 1e-6;
  bool measured = false;
  std::size_t most_bytes = std::size_t{4} << 30;
};

/// What a grid took.
struct GridWork {
  int nx = 0, ny = 0;    // grid lines that see vorticity
  int px = 0, py = 0;    // of the transforms
  int width = 0;         // grid lines that a blob is spread to, in each direction
  double spacing = 0.0;  // [m]
};

/// Velocity of all blobs at the targets, from one uniform grid: blobs are spread to it, velocities
/// found on it by Fourier transforms in free space, and read off.
///
///   u_i = sum_j gamma_j/(2 pi) (1 - exp(-r^2/sigma^2)) / r^2 (-dy, dx),  (dx, dy) = x_i - x_j
///
/// A rival of the trees, and good for what a grid is good for: blobs of one core size sigma, which
/// fill their space. The grid resolves sigma, 2 to 6 lines to a core; its memory and cost grow with
/// area/sigma^2, not with the blobs.
///
/// error    ||u - u_exact||_2 <= tolerance ||u_exact||_2 for blobs whose signs are random or smooth
///          in space, down to 1e-13 (tests/bench/rivals/grid.cpp); where far parts of the flow
///          cancel, relative to what they would be if they did not
/// cost     O(n width^2 + m log m), m = 6 area/spacing^2 for a square
/// phase    told "plan", "spread", "transform", "gather" as each begins
/// threads  OpenMP; same bits for any number
/// throws   std::invalid_argument as check(blobs), check(targets), check_result; for bare vortices
///          and for cores of several sizes; for cores so small that the grid would need more memory
///          than allowed
/// source   Potts & Steidl, SIAM J. Sci. Comput. 24 (2003); Vico, Greengard & Ferrando,
///          J. Comput. Phys. 323 (2016); af Klinteberg, Shamshirgar & Tornberg, Res. Math. Sci. 4
///          (2017)
GridWork velocity_grid(const fmm::Sources& blobs, const fmm::Targets& targets,
                       const GridOptions& options, std::span<double> u, std::span<double> v,
                       const tree::Phase& phase = {});

}  // namespace vortree::bench
