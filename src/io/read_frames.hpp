#pragma once

#include <filesystem>
#include <vector>

#include "io/frames.hpp"

namespace vortree::io {

/// Some frames of a frames file, evenly chosen, the last one among them; by ascending step.
///
/// most    at most so many, 1 or more
/// throws  InputError if the file cannot be read or a chosen frame is damaged
[[nodiscard]] std::vector<Frame> read_frames(const std::filesystem::path& file, std::size_t most);

}  // namespace vortree::io
