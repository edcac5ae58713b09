#pragma once

#include <cstdint>

#include "vortex/coarsening.hpp"
#include "vortex/parts.hpp"

namespace vortree::vortex {

/// How wide blobs are split.
///
/// sigma_max   blobs wider than this split [m]
/// alpha       width of a child, in widths of its parent (0 < alpha < 1)
/// children    on a ring around the parent's centre
/// seed        of the hash that turns the ring
/// coarsening  where there is a wall: wider cores away from it
struct Splitting {
  double sigma_max;
  double alpha = 0.7;
  int children = 4;
  std::uint64_t seed = 1;
  Coarsening coarsening{};
};

/// Replaces each blob wider than sigma_max (widened as its place allows) by M children of gamma/M
/// and width alpha sigma on a ring of radius sigma sqrt(1 - alpha^2). Conserves circulation,
/// impulse and second moment; next to a wall circulation and impulse (children that land in the
/// body are reflected, the folded picture's exact answer, and all are shifted together to keep the
/// mean acting position).
///
/// The ring's angle, one of 1024, is a hash of seed, step, |gamma| and sigma (to six digits),
/// turned with the sign of gamma: runs repeat bit for bit, and the mirror image of a symmetric flow
/// splits into mirror images.
///
/// error   O(sigma^2 (1 - alpha^2)^2) of the Gaussian's fourth moments
/// source  Rossi, SIAM J. Sci. Comput. 17 (1996)
void split_wide(Blobs& blobs, const Splitting& splitting, const Shape* wall, std::uint64_t step);

/// The same for what is to be merged next: children keep the acting positions that they are to
/// have.
Parts split_apart(const Blobs& blobs, const Splitting& splitting, const Shape* wall,
                  std::uint64_t step);

}  // namespace vortree::vortex
