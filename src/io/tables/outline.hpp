#pragma once

#include <filesystem>

#include "body/settings.hpp"

namespace vortree::io {

/// The outline of a body as a table of x and y as seen from its centre, in the scene's unit of
/// length: 513 points, the last one the first again, closer where the outline bends. A note above
/// them says the length D that coefficients go by: "# D = 1".
///
/// throws  std::runtime_error if it cannot be written
void write_outline(const std::filesystem::path&, const body::BodySettings&);

}  // namespace vortree::io
