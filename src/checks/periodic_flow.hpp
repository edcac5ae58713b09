#pragma once

#include "checks/finished.hpp"

namespace vortree::checks {

/// A flow that fills the plane: velocity and pressure at the end off the exact ones, volume and
/// momentum of the particles all the way.
void check_periodic_flow(std::vector<Verdict>& list, const Finished& run);

}  // namespace vortree::checks
