#pragma once

#include <string>
#include <vector>

#include "io/scene/scene.hpp"

namespace vortree::checks {

/// Doubts (warnings.hpp) about the means of a scene, whatever flow it has: splitting, merging,
/// other diffusion, sums of velocities; and about what it asks to be written.
std::vector<std::string> warnings_of_means(const io::Scene& scene);

}  // namespace vortree::checks
