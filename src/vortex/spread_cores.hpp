#pragma once

#include "vortex/blobs.hpp"

namespace vortree::vortex {

/// Diffusion: sigma^2 += 4 nu dt, the exact solution for each Gaussian, folded or free.
/// source  Leonard, J. Comput. Phys. 37 (1980)
void spread_cores(Blobs& blobs, double nu, double dt);

}  // namespace vortree::vortex
