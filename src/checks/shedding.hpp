#pragma once

#include "checks/finished.hpp"

namespace vortree::checks {

/// A wake that sheds vortices, from T = shedding_from on: its frequency, its mean drag and lift. Of
/// several bodies all lifts must have the frequency; mean drag, mean and root mean square of the
/// lift are told of each, by the wall, and so is how far each lift is ahead of that of the first.
void check_shedding(std::vector<Verdict>& list, const Finished& run);

}  // namespace vortree::checks
