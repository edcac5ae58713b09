#pragma once

#include <vector>

#include "vortex/blobs.hpp"
#include "vortex/shape.hpp"

namespace vortree::vortex {

/// Where blobs act, and with which core: their centres in free space; next to a wall the mean of
/// the folded core, whose width is that of the folded distribution,
///
///   sigma_e^2 = (sigma^2 + 2 v_n)/2.
///
/// Circulation times acting position is the blob's impulse.
struct Acting {
  std::vector<double> x, y, sigma;

  Vec2 at(std::size_t i) const { return {x[i], y[i]}; }
};

/// A blob by its acting position.
struct Placed {
  Vec2 centre;
  double sigma;
};

Acting acting(const Blobs& blobs, const Shape* wall);
Vec2 acting_position(Vec2 centre, double sigma, const Shape* wall);

/// The blob of core sigma whose acting position is `mean` (sigma shrinks only if the wall is too
/// near; a mean within the body is brought out of it).
Placed place(Vec2 mean, double sigma, const Shape* wall);

}  // namespace vortree::vortex
