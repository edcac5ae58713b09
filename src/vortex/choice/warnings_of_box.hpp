#pragma once

#include <string>
#include <vector>

#include "flow/warnings.hpp"
#include "vortex/settings.hpp"

namespace vortree::vortex {

/// The part of warnings(scene) that is about merging.box: a side so near to the body that the drag
/// feels what is taken away there, with the box that keeps it to 1 %. A cylinder at Re = 550 had a
/// drag of 21 for 1.1 with the box around it at 0.5 D, 1.8 at 0.6 D, 1.3 with the sides alone at
/// 0.6 D; at 8 D behind it 0.8 % remained (Re = 20 and 100), at 4 D 4 to 7 %.
flow::Warnings warnings_of_box(const VortexCase& scene);

}  // namespace vortree::vortex
