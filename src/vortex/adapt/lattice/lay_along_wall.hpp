#pragma once

#include <array>
#include <span>

#include "vortex/adapt/adaptation.hpp"

namespace vortree::vortex {

/// A lattice that follows a wall: columns at arcs k b, b = perimeter/K as near to h as a whole
/// number K has it, rows at distances j h along their normals, j = 0, 1, ...; row 0 is on the wall.
/// Every node is a round blob of sigma^2 = s^2 which the wall folds:
///
///   h^2 = 3/2 Delta, Delta = what sigma^2 grows by from one laying to the next (4 nu dt a step),
///         though h <= 0.9 sigma_max;   s = 0.856 h
///
/// Then what is laid on it again has spread by V = Delta/(2 h^2) = 1/3 of a step squared, and three
/// shares V/2, 1 - V, V/2 have the fourth moment of a Gaussian, too: the explicit scheme for the
/// heat equation with nu dt/h^2 = 1/6, of fourth order.
///
/// step    h [m]
/// square  s^2 [m^2]
struct WallLattice {
  double step, square;

  /// spread  Delta [m^2]; 0: not known
  WallLattice(double sigma_max, double spread);

  /// Whether a core can be laid where this is its nearest wall point: in no direction much narrower
  /// than a node, nor wider than 3.7 steps more, and where the wall turns by less than a tenth in
  /// a step.
  bool takes(const Core& core, const body::WallPoint& nearest) const;

  /// Whether so many columns can be.
  bool fits(const body::Shape& wall) const;
};

/// Shares of nodes -reach .. reach for what lies `d` steps from node 0, |d| <= 1/2, and has spread
/// by a variance of V steps squared beyond a node's own. Sum, mean and variance are exact. Up to V
/// = 1/2 there are three,
///
///   (m - d)/2, 1 - m, (m + d)/2,   m = V + d^2;
///
/// wider ones sample a Gaussian to four widths, whose moments are right to exp(-2 pi^2 V), 5e-5 or
/// less, but for what lies beyond, 0.7 % of the fourth; the middle three are mended.
class SpreadShares {
 public:
  static constexpr int most = 16;

  SpreadShares(double d, double V);
  int reach() const { return reach_; }
  double operator[](int k) const { return share_[most + k]; }

  static int reach_of(double V);

 private:
  int reach_;
  std::array<double, 2 * most + 1> share_{};
};

/// A blob beside the wall that is to be laid onto it.
struct WideAtWall {
  Vec2 centre;
  double gamma;
  Core core;
  body::WallPoint nearest;
};

/// Lays blobs onto the lattice along the wall, and appends the nodes that are not 0 by columns.
///
/// A blob has shares of columns by the arc of its wall point and its variance along the wall,
/// in arcs at the wall, and of rows by its height (folded_centroid.hpp) and its variance across. A
/// row behind the wall is its image before it: a layer at a wall is even in the distance, so that
/// this is the lattice of the plane, which keeps what is smooth. What a blob is tilted goes to the
/// four corners about its middle node. Last the two neighbors along and across take up what the
/// nodes' folded centroids miss of the blob's.
///
/// Shares are added as whole numbers (units.hpp).
/// error   circulation and impulse: round-off; the mean distance from the wall of a sheet released
///         at once grows to 0.3 to 0.8 % too much (tests/vortex/adapt/lattice/lay_along_wall.cpp)
/// cost    O(blobs + columns)
/// source  our own
void lay_along_wall(AdaptedBlobs& adapted, std::span<const WideAtWall> blobs,
                    const WallLattice& lattice, const body::Shape& wall);

}  // namespace vortree::vortex
