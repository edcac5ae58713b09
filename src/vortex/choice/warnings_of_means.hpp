#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flow/warnings.hpp"
#include "vortex/settings.hpp"

namespace vortree::vortex {

/// Doubts (warnings.hpp) about the means of a scene, whatever flow it has: splitting, merging,
/// other diffusion, sums of velocities; and about what it asks to be written.
flow::Warnings warnings_of_means(const VortexCase& scene);

/// What so few terms of a series err by, whatever tolerance is asked for; nothing for enough of
/// them, and for 0, which chooses them.
///
/// given      the setting as the user wrote it: "velocity.order = 3"
/// tolerance  what the tolerance is called there
std::string doubt_of_terms(int order, std::string_view given, std::string_view tolerance);

}  // namespace vortree::vortex
