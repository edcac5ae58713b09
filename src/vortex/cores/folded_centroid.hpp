#pragma once

#include <vector>

#include "body/shape.hpp"
#include "vortex/blobs/blobs.hpp"

namespace vortree::vortex {

/// Where blobs act, and with which core: their centres in free space; next to a wall the mean of
/// the folded core, whose width is that of the folded distribution,
///
///   sigma_e^2 = v_n + v_t,   v_t = sigma^2/2 along the wall.
///
/// Circulation times acting position is the blob's impulse.
struct Acting {
  std::vector<double> x, y, sigma;

  Vec2 at(std::size_t i) const { return {x[i], y[i]}; }
};

Acting acting(const Blobs& blobs, const body::Shape* wall);

/// A blob's place and core: its own, or those with which it acts.
///
/// A blob's own core has, across the wall, the variance of the Gaussian that is folded, and, as to
/// the tilt between the two directions, that of the folded distribution: a Gaussian centred on the
/// wall, folded, would have none, but vorticity sheared along the wall has.
struct Placed {
  Vec2 centre;
  Core core;
};

/// How a blob acts.
Placed acting_blob(Vec2 centre, const Core& core, const body::Shape* wall);

/// The blob of this core whose acting position is `mean` (the core shrinks only if the wall is too
/// near; a mean within the body is brought out of it).
Placed place(Vec2 mean, const Core& core, const body::Shape* wall);

/// The blob that acts at `acting.centre` with `acting.core`, or, where a folded core is never so
/// wide for its distance, with a narrower one: acting_blob undone.
///
/// error  as place_with_variance (folded_core.hpp)
Placed place_acting(const Placed& acting, const body::Shape* wall);

/// A blob that has gone `way` in a time dt, through a flow of this gradient at its acting position:
/// its covariance V, as it acts, becomes F V F^T, F = exp(G dt). Beside a wall it keeps its width
/// along it: shear spreads vorticity there where little changes, but a straight core that reaches
/// far along a curved wall would leave it.
Placed strained(const Placed& blob, Vec2 way, const Gradient& gradient, double dt,
                const body::Shape* wall);

}  // namespace vortree::vortex
