#pragma once

#include "flow/case.hpp"
#include "flow/columns.hpp"

namespace vortree::flow {

/// Notes where motions that come from files have led until t, so that a run that goes on can tell
/// whether the files still say the same. Nothing of a scene without such.
void save_courses(const Case& of, double t, State& state);

/// throws  Refused, with the key of the file, if one of them leads elsewhere than it did, by more
///         than 1e-9 of how far it leads; nothing is held of what was saved without such notes
void hold_courses(const Case& of, const State& state);

}  // namespace vortree::flow
