#pragma once

#include "checks/finished.hpp"

namespace vortree::checks {

/// A wake that sheds vortices: its frequency, and its mean drag and lift, from T = shedding_from on.
void check_shedding(std::vector<Verdict>& list, const Finished& run);

}  // namespace vortree::checks
