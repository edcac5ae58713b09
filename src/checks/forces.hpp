#pragma once

#include "checks/finished.hpp"

namespace vortree::checks {

/// Drag, length of the wake and separation beside a body, held against a reference.
void check_drag(std::vector<Verdict>& list, const Finished& run);

/// Lift beside a body, held against a reference: a share of the largest lift that this has at the
/// times of the rows that count.
void check_lift(std::vector<Verdict>& list, const Finished& run);

/// Mean drag until T = 0.1 on a circle that is at rest when the stream sets in, held against the
/// exact one (exact/cylinder_drag.hpp) at the same times.
void check_early_drag(std::vector<Verdict>& list, const Finished& run);

/// One route to a force against the other; lift that should not be.
void check_forces(std::vector<Verdict>& list, const Finished& run);

}  // namespace vortree::checks
