#pragma once

#include <string>
#include <vector>

#include "flow/case.hpp"

namespace vortree::flow {

/// A sentence each.
using Warnings = std::vector<std::string>;

/// Doubts about a scene before it is run, whatever method computes it: what the shape of its body
/// makes of what is written (body::told_of), a sentence for each time
/// that it asks for and a run does not meet (time.end, frames and pictures that are no multiple of
/// time.dt, with what comes instead, and pictures beyond the end), and for pictures of nothing.
Warnings warnings(const Case& of);

}  // namespace vortree::flow
