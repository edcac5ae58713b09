#pragma once

#include <filesystem>

#include "flow/case.hpp"

namespace vortree::io {

/// The outlines of bodies as a table of x and y as seen from the centre of the first, in the
/// scene's unit of length: 513 points of each, the last one the first again, closer where the
/// outline bends; of several, the number of the body from 1 on. A note above them says the length D
/// that coefficients go by, that of the first: "# D = 1".
///
/// throws  std::runtime_error if it cannot be written
void write_outlines(const std::filesystem::path&, const flow::BodyList& bodies);

}  // namespace vortree::io
