#pragma once

#include <cstddef>

namespace vortree::app {

/// The most memory that this process has held at any time so far (resident set) [bytes].
std::size_t peak_bytes();

}  // namespace vortree::app
