#pragma once

#include "checks/finished.hpp"

namespace vortree::checks {

/// Drag, length of the wake and separation beside a body, held against a reference.
void check_drag(std::vector<Verdict>& list, const Finished& run);

/// One route to a force against the other; lift that should not be.
void check_forces(std::vector<Verdict>& list, const Finished& run);

}  // namespace vortree::checks
