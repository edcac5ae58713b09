#pragma once

#include <string>
#include <vector>

#include "io/scene/scene.hpp"

namespace vortree::checks {

/// A sentence for each time that a scene asks for and a run does not meet: time.end, frames and
/// pictures that are no multiple of time.dt, with what comes instead, and pictures beyond the end.
std::vector<std::string> warnings_of_times(const io::Scene& scene);

}  // namespace vortree::checks
