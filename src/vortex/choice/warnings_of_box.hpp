#pragma once

#include <string>
#include <vector>

#include "flow/warnings.hpp"
#include "vortex/settings.hpp"

namespace vortree::vortex {

/// The part of warnings(scene) that is about merging.box: a side so near to the body that the drag
/// feels what leaves there, since it then goes on with the stream alone, with the box that keeps it
/// to 1 %. Of a cylinder at Re = 550, to T = 7, the drag was off by at most 94 % with the box
/// around it at 0.5 D, 13 % at 0.6 D, 10 % at 0.75 D, 3.6 % at 1 D and 1.3 D behind it; to T = 40
/// by 0.9 and 0.4 % with it 8 D behind (Re = 20 and 100), 1.9 and 0.6 % at 4 D, 3.4 and 6.7 % at
/// 2 D.
flow::Warnings warnings_of_box(const VortexCase& scene);

}  // namespace vortree::vortex
