#pragma once

#include <algorithm>
#include <cmath>

namespace vortree::vortex {

/// Cores that widen away from the body: at a distance d from the wall a blob may be
///
///   widening = max(1, (d/from)^(3/4))
///
/// times as wide as sigma_max, and a merger may err by as many times the tolerance.
///
/// A merger allowed to err by tolerance at the distance of a core is felt at the body as
/// tolerance (sigma/d)^3. With both as wide as this law has them that is the same at every d >
/// from: no merger anywhere errs more, at the body, than one near it. Blobs per area fall as
/// d^(-3/2), so that a wake which goes on for ever has a bounded number of them.
///
/// from  distance from the wall where cores begin to widen [m]; infinite: nowhere
struct Coarsening {
  double from = INFINITY;

  bool everywhere_alike() const { return from == INFINITY; }
  float widening(double distance) const {
    return distance > from ? static_cast<float>(std::pow(distance / from, 0.75)) : 1.0f;
  }
};

}  // namespace vortree::vortex
