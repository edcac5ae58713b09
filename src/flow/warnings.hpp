#pragma once

#include <string>
#include <vector>

#include "flow/case.hpp"

namespace vortree::flow {

/// Doubts about a scene before it is run, whatever method computes it: a sentence for each time that
/// it asks for and a run does not meet (time.end, frames and pictures that are no multiple of
/// time.dt, with what comes instead, and pictures beyond the end), and for pictures of nothing.
std::vector<std::string> warnings(const Case& of);

}  // namespace vortree::flow
