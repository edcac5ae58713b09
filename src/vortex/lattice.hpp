#pragma once

#include "vortex/blobs.hpp"

namespace vortree::vortex {

/// A Gaussian vortex of width `core` cut into blobs of width sigma_0 on a square lattice of step h:
///
///   gamma_ij = gamma h^2/(pi s^2) exp(-|x_ij - centre|^2/s^2),   s^2 = core^2 - sigma_0^2,
///
/// which the blobs' own width makes up to the whole again.
/// error   O(exp(-(pi sigma_0/h)^2)) relative; blobs below 1e-12 of the strongest are left out, and
///         the rest scaled to hold the circulation exactly
/// throws  std::invalid_argument unless core > sigma_0 > 0 and h > 0
Blobs gaussian_vortex(Vec2 centre, double gamma, double core, double sigma_0, double h);

}  // namespace vortree::vortex
