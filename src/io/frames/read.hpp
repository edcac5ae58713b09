#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "io/frames/frames.hpp"

namespace vortree::io {

/// Some frames of a frames file, evenly chosen, the last one among them; by ascending step.
///
/// most    at most so many, 1 or more
/// throws  InputError if the file cannot be read or a chosen frame is damaged
[[nodiscard]] std::vector<Frame> read_frames(const std::filesystem::path& file, std::size_t most);

/// One frame, by its place in the file, counted from 0; the last if none is said.
/// throws  InputError, with the file, if it cannot be read, has no such frame or a damaged one
[[nodiscard]] Frame read_frame_of(const std::filesystem::path& file,
                                  std::optional<std::size_t> number);

/// How many frames a file has, and the time of the last (0 without frames); looks at no columns.
struct FramesLabel {
  std::size_t frames = 0;
  double last_time = 0;
};

/// throws  InputError if the file cannot be read as it stands
[[nodiscard]] FramesLabel label_of_frames(const std::filesystem::path& file);

}  // namespace vortree::io
