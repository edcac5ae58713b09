#pragma once

#include <vector>

#include "body/shape.hpp"
#include "vortex/blobs/blobs.hpp"
#include "vortex/cores/wall_points.hpp"

namespace vortree::vortex {

/// A blob's place and core: its own, or the folded ones, with which it acts.
///
/// A blob's own core has, across the wall, the variance of the Gaussian that is folded, and, as to
/// the tilt between the two directions, that of the folded distribution: a Gaussian centred on the
/// wall, folded, would have none, but vorticity sheared along the wall has.
struct Placed {
  Vec2 centre;
  Core core;
};

/// Where blobs act, and with which core: their centres in free space; next to a wall the folded
/// centroid, the mean of the folded core, and the width of the folded distribution,
///
///   sigma_e^2 = v_n + v_t,   v_t = sigma^2/2 along the wall.
///
/// Circulation times folded centroid is the blob's impulse.
///
/// xx, xy  what the covariance of a folded core has beyond its mean over all directions [m^2]
///         (covariance.hpp): a folded core is wider along the wall than across it. 0 for a core
///         that the wall does not fold; empty in free space
/// wall    points nearest to where they act, of those that the wall folds
struct FoldedBlobs {
  std::vector<double> x, y, sigma, xx{}, xy{};
  WallPoints wall{};

  Vec2 at(std::size_t i) const { return {x[i], y[i]}; }
  Deviator deviator(std::size_t i) const {
    return xx.empty() ? Deviator{} : Deviator{xx[i], xy[i]};
  }
  /// One that the wall folds.
  Placed folded(std::size_t i) const { return {at(i), {sigma[i] * sigma[i], deviator(i)}}; }
};

/// found  wall points nearest to the blobs' centres
FoldedBlobs fold(const Blobs& blobs, const body::Shape* wall,
                 const WallPoints& found = WallPoints());

/// How far from the wall the Gaussian is centred that is folded: the blob's centre and the sag of
/// its core. No blob has less than 0; the centre of one that is drawn out along a bent wall may lie
/// behind it.
double height(const body::WallPoint& nearest, const Covariance& core);

/// How a blob acts: folded back by the wall.
Placed fold(Vec2 centre, const Core& core, const body::Shape* wall);

/// The blob of this core whose folded centroid is `mean` (the core shrinks only if the wall is too
/// near; a mean within the body is brought out of it).
Placed place(Vec2 mean, const Core& core, const body::Shape* wall);

/// The blob that acts at `folded.centre` with `folded.core`, or, where a folded core is never so
/// wide for its distance, with a narrower one: fold undone.
///
/// nearest  wall point of folded.centre, or one infinitely far
/// error    as place_with_variance (folded_core.hpp)
Placed unfold(const Placed& folded, const body::WallPoint& nearest);
Placed unfold(const Placed& folded, const body::Shape* wall);

/// How a blob acts that has acted as `folded` and has gone `way` in a time dt, through a flow of
/// this gradient: its covariance V becomes F V F^T, F = exp(G dt). Beside a wall it keeps its width
/// along it: shear spreads vorticity there where little changes, but a straight core that reaches
/// far along a curved wall would leave it.
///
/// nearest  wall point of folded.centre if the wall folds the blob, or one infinitely far
/// turned   by how much that wall turns meanwhile, anticlockwise
Placed strained(const Placed& folded, const body::WallPoint& nearest, Vec2 way,
                const Gradient& gradient, double dt, double turned = 0);

/// As far as the wall folds a core: `folded::support` of its widest sigma.
double reach_of(const Core& core);

}  // namespace vortree::vortex
