#pragma once

#include <cstddef>

namespace vortree::app {

/// The most memory that this process has held at any time so far (resident set) [bytes].
std::size_t peak_bytes();

/// What this process may have at most: the machine's memory, or less by a limit of the process or
/// of its control group.
double machine_bytes();

}  // namespace vortree::app
