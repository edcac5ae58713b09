#pragma once

#include "checks/finished.hpp"

namespace vortree::checks {

/// Vorticity along the wall at the times that wall.csv and a reference share.
void check_wall_vorticity(std::vector<Verdict>& list, const Finished& run);

/// C_p at the front, where the wall faces what comes towards it, at the times of wall.csv that a
/// reference covers.
void check_front_pressure(std::vector<Verdict>& list, const Finished& run);

}  // namespace vortree::checks
