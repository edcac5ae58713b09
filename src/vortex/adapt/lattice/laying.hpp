#pragma once

#include <cstdint>
#include <span>

#include "vortex/adapt/adaptation.hpp"
#include "vortex/adapt/lattice/lay_along_wall.hpp"
#include "vortex/adapt/lattice/lay_onto_lattice.hpp"
#include "vortex/adapt/split_wide.hpp"

namespace vortree::vortex {

/// Where blobs are laid onto lattices (lay_onto_lattice.hpp), when, and onto which.
///
/// Where: wherever all nodes that a blob reaches are free of the wall's folding, farther from it
/// than 4 cores and 1.5 sqrt(2) steps of the lattice, together 4.99 sigma_max 2^(k/2).
///
/// Onto which: level k = floor(2 log2 widening) of the place (coarsening.hpp), so that lattices
/// coarsen with the cores; of the coarsest with sigma^2 >= least() if a blob is wider than two
/// levels take, so that it narrows step by step. In free space faint blobs, |gamma|/sigma^2 <
/// `faint`, have lattices up to twice as wide, (faint sigma^2/|gamma|)^(1/4) times: vorticity
/// spreads by a row of nodes with each lattice, and where it has all but ended these would
/// otherwise be most of all blobs.
///
/// Nearer to the wall than that there is the lattice along it (lay_along_wall.hpp), with the turn
/// of level 0.
///
/// When: all of a level in the same step, each 2^k P-th, P steps the least in which a node's square
/// spreads to least(); but for blobs narrower than nodes, which wait for the next turn. So fluid
/// that leaves the wall's zone joins the lattice that is there. Were each blob laid when it is wide
/// enough, two lattices and more would lie over each other, with 1.6 times the blobs. Where cores
/// of free space are strained P is no more than Splitting::strained_steps: what two halves
/// (cores/halves.hpp) can tell of a core goes by how long it has become.
class Laying {
 public:
  static constexpr std::int8_t none = -1, along_wall = -2;

  /// What becomes of a blob: whether lattices are where it is, and onto which level it is laid now,
  /// along the wall, or nowhere. widening, leniency: see AdaptedBlob.
  struct Lot {
    bool free = false;
    std::int8_t level = none;
    float widening = 1, leniency = 1;
  };

  /// step  from 1; in its upper half that of a substep
  Laying(const Splitting& splitting, const body::Shape* wall, std::uint64_t step);

  /// nearest   wall point, infinitely far if it is more than seen_from(widest core)
  /// distance  from the wall
  /// widening  of its place
  Lot lot(const Blobs& blobs, std::size_t i, const body::WallPoint& nearest, double distance,
          float widening) const;
  double seen_from(double widest) const;

  /// Appends the nodes that blobs of these levels become.
  ///
  /// nearest  wall points of those along the wall
  void append_nodes(AdaptedBlobs& adapted, const Blobs& blobs, std::span<const std::int8_t> level,
                    const WallPoints& nearest) const;

 private:
  int finest(double distance, double widening) const;
  int coarsest(double distance) const;
  bool due(double square, int finest) const;
  bool goes_along_wall(const Core& core, const body::WallPoint& nearest) const;
  void append_free_nodes(Unwritten<AdaptedBlob>& all, std::span<const WideBlob> wide) const;
  bool in_turn(int level) const;
  bool strains() const { return !wall_ && splitting_.strained_steps > 0; }
  double faintness(double gamma, double square) const;
  AdaptedBlob node(Vec2 at, double gamma, int level) const;
  float widening(double of_place, int finest) const;

  const Splitting& splitting_;
  const body::Shape* wall_;
  std::uint64_t clock_, period_ = 0;  // 0: each blob when it is wide enough
  WallLattice wall_lattice_;
  bool wall_is_followed_ = false;
};

}  // namespace vortree::vortex
