#pragma once

#include <stdexcept>
#include <string>

#include "vortex/adapt/adaptation.hpp"

namespace vortree::vortex {

/// How close blobs are merged.
///
/// tolerance   velocity error allowed for a merger [m/s]; 0: never merge
/// reach       partners are closer than this many of the smaller core
/// sigma_max   the widest core a merger may leave [m]
struct Merging {
  double tolerance;
  double reach = 2;
  double sigma_max;
};

/// So many blobs lie so close that each has thousands within its reach, and still may not merge.
struct Crowded : std::runtime_error {
  std::size_t blobs;

  explicit Crowded(std::size_t count)
      : std::runtime_error(std::to_string(count) + " blobs crowd in one place and cannot merge"),
        blobs(count) {}
};

/// Merges pairs of like sign, each the partner with which the other errs least:
///
///   gamma = sum gamma_i,   x = sum gamma_i x_i/gamma,
///   sigma^2 = sum gamma_i (sigma_i^2 + |x_i - x|^2)/gamma,
///   allowed if |g1 g2/(g1 + g2)| (d^2 + |sigma_1^2 - sigma_2^2|) <= tolerance min(sigma)^3,
///
/// d = |x_1 - x_2|. The left side is the moment that the pair and the merged blob differ in;
/// divided by sigma^3 it is the velocity error at a distance of a core. Conserves circulation,
/// impulse and second moment. Next to a wall x is the folded centroid; what the pair spreads along
/// the wall stays in the covariance, so that merging along it diffuses nothing away from it; there
/// a merger may pass sigma_max a little.
///
/// Away from a body sigma_max is as many times larger as the smaller widening of the pair
/// (coarsening.hpp), and min(sigma)^3 becomes the smaller sigma^3 times its own widening.
/// Where blobs are laid onto lattices, that is a tenth of it (AdaptedBlob::leniency), and those
/// that could merge with none as strong a core away, |gamma|/2 > tolerance leniency sigma, take no
/// part: in the end they stand behind the others, in their order.
///
/// Most pairs are neighbors: first windows of 32 of them merge in the cache (merge_windows.hpp),
/// then whoever is left chooses among all within reach, until no pair is left. Whom a blob chooses
/// depends on places alone: the mirror image (in the x axis) of a flow merges into its mirror image
/// (up to ties), whatever the order of the blobs and the threads. The blobs come out sorted by sign
/// and place.
///
/// throws  Crowded, where the cost would go with the square of the blobs
/// cost    O(blobs) for the windows; for what they leave, times the candidates within reach
void merge_close(Blobs& blobs, const Merging& merging, const body::Shape* wall);

/// The same for what was split; blobs beside a wall are still to be put there (pack).
void merge_close(AdaptedBlobs& adapted, const Merging& merging);

}  // namespace vortree::vortex
