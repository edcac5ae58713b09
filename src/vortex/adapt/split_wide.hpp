#pragma once

#include <cstdint>

#include "vortex/adapt/adaptation.hpp"
#include "vortex/adapt/coarsening.hpp"

namespace vortree::vortex {

/// How wide blobs are split.
///
/// sigma_max   blobs wider than this split [m]
/// alpha       width of a child, in widths of its parent (0 < alpha < 1)
/// children    around the parent's centre, away from a wall
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
/// and width alpha sigma on an ellipse: the ring of radius sigma sqrt(1 - alpha^2) drawn out as the
/// parent's strain has it (children keep what would draw it out beyond nine tenths). Conserves
/// circulation, impulse and all second moments.
///
/// Beside a wall there are four children, in a cross along and across it, leaning as the parent's
/// tilt: their shares and places keep the mean and the mean square of the distance from the wall
/// (at a flat one), and the impulse exactly. A ring reflected at the wall keeps only one of the
/// two.
///
/// The ring's angle, one of 1024, is a hash of seed, step, |gamma| and sigma (to six digits),
/// turned with the sign of gamma: runs repeat bit for bit, and the mirror image of a symmetric flow
/// splits into mirror images.
///
/// error   of the mean fourth power of the distance, sigma^4 (1 - alpha^2)^2 of a round core's 2
///         sigma^4
/// source  Rossi, SIAM J. Sci. Comput. 17 (1996); the ellipse and the cross are our own
void split_wide(Blobs& blobs, const Splitting& splitting, const body::Shape* wall,
                std::uint64_t step);

/// The same for what is to be merged next: children keep the folded centroids that they are to
/// have.
AdaptedBlobs split_apart(const Blobs& blobs, const Splitting& splitting, const body::Shape* wall,
                         std::uint64_t step);

}  // namespace vortree::vortex
