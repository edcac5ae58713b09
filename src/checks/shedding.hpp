#pragma once

#include "checks/finished.hpp"

namespace vortree::checks {

/// A wake that sheds vortices, from T = shedding_from on: its frequency, its mean drag and lift.
void check_shedding(std::vector<Verdict>& list, const Finished& run);

}  // namespace vortree::checks
