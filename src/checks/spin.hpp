#pragma once

#include "checks/finished.hpp"

namespace vortree::checks {

/// The flow at the end around a circle that spins in fluid at rest, held against the exact one
/// (exact/spinning_cylinder.hpp) on seven rays, from 0.1 to 6 sqrt(nu t)
/// off the wall.
///
/// velocity_max   largest difference, as a share of the wall's speed
/// vorticity_max  the same, as a share of the exact vorticity at the wall; point by point, so that
///                it counts the noise of splitting and merging, too
void check_spin(std::vector<Verdict>& list, const Finished& run);

}  // namespace vortree::checks
