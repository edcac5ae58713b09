#pragma once

#include <cstdint>
#include <vector>

#include "tree/base/memory.hpp"
#include "vortex/cores/folded_centroid.hpp"

namespace vortree::vortex {

/// A blob in the midst of splitting and merging: its centre, circulation, sigma squared, and the
/// traceless part of its covariance.
///
/// at_wall   number of what is known of it beside the wall, or no_wall
/// widening  how many times wider cores may be where it is (coarsening.hpp)
/// leniency  how many times the tolerance its mergers may err by: its widening near the wall, less
///           where blobs are laid onto lattices (lay_onto_lattice.hpp)
struct AdaptedBlob {
  double x, y, gamma, square;
  Deviator deviator;
  std::uint32_t at_wall;
  float widening, leniency;

  Vec2 centre() const { return {x, y}; }
  Core core() const { return {square, deviator}; }
};

inline constexpr std::uint32_t no_wall = ~0u;

/// What such a blob beside a wall knows besides: its folded centroid, centre + offset, and mean and
/// variance of the distance from the wall of what it folds. These are kept, and the core is put
/// around them at the end.
///
/// normal  of the wall, outward
/// mean    distance along the bent wall: that of the centroid and k v_t/2 (folded_core.hpp) [m]
/// across  variance [m^2]
/// moved   the core is still to be put there
struct AtWall {
  Vec2 offset, normal;
  double mean, across;
  bool moved;
};

/// Those of a flow. Splitting and merging conserve sum gamma (centre + offset) exactly, without
/// an inverse of the folded moments for each child and each merger: one for each blob that is left.
///
/// laid, split  so many blobs have become nodes of lattices, or children
struct AdaptedBlobs {
  Unwritten<AdaptedBlob> all;
  std::vector<AtWall> at_wall;
  std::size_t laid = 0, split = 0;
};

/// What a blob with this core knows of the wall point nearest to its centre.
AtWall beside(const body::WallPoint& nearest, const Core& core);

/// From blobs to what splits and merges, and back.
AdaptedBlobs unpack(const Blobs& blobs, const body::Shape* wall);
Blobs pack(const AdaptedBlobs& adapted, const body::Shape* wall);

}  // namespace vortree::vortex
