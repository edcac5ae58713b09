#pragma once

#include <cstdint>

#include "vortex/adapt/adaptation.hpp"
#include "vortex/adapt/coarsening.hpp"
#include "vortex/adapt/split_scheme.hpp"

namespace vortree::vortex {

/// How wide blobs are split.
///
/// sigma_max   blobs wider than this split [m]
/// alpha       width of a child, in widths of its parent (0 < alpha < 1)
/// children    around the parent's centre, away from a wall
/// seed        of the hash that turns the ring
/// coarsening  where there is a wall: wider cores away from it
/// scheme      what they become away from a wall
/// faint       in free space: vorticity so weak that lattices are coarser (laying.hpp) [1/s]
/// spread      what a step adds to sigma^2 [m^2], which a step tells; 0: each blob is laid onto a
///             lattice when it is wide enough
/// strained_steps  in free space, after how many steps strained cores are laid onto lattices, wide
///             enough or not; 0: cores stay round
struct Splitting {
  double sigma_max;
  double alpha = 0.7;
  int children = 4;
  std::uint64_t seed = 1;
  Coarsening coarsening{};
  SplitScheme scheme = SplitScheme::ring;
  double faint = 0;
  double spread = 0;
  std::uint64_t strained_steps = 0;
};

/// By the scheme `lattice`, lays wide blobs onto lattices: of the plane wherever the wall is far
/// enough, else along the wall (laying.hpp). Around edges too sharp for that, and by the scheme
/// `ring`:
///
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
///
/// found  wall points nearest to the blobs' centres
AdaptedBlobs split_apart(const Blobs& blobs, const Splitting& splitting, const body::Shape* wall,
                         std::uint64_t step, const WallPoints& found = WallPoints());

}  // namespace vortree::vortex
