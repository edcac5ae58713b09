#pragma once

#include "flow/initial/settings.hpp"
#include "sph/cloud/cloud.hpp"

namespace vortree::sph {

/// Adds the velocity of the vorticity that a flow begins with, in unbounded fluid, to what the
/// particles have: of Gaussian cores on a lattice, whose width is a sixth of the least half width.
/// Returns their circulation.
///
/// seen_from  where the cloud's origin is in the scene [L]
/// error      5e-5 of the vorticity, and 1e-6 of the sums
/// cost       O(particles): fmm/plan.hpp
double add_initial_vortices(Cloud& cloud, const flow::InitialSettings& initial, Vec2 seen_from);

}  // namespace vortree::sph
