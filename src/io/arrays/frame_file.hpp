#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "io/arrays/array_file.hpp"
#include "io/input_error.hpp"

namespace vortree::io {

/// A frame of a run by its place in the file.
struct FramePointer {
  std::filesystem::path file;
  std::optional<std::size_t> number;  ///< counted from 0; none: the last
};

/// What FILE::12, FILE::last, DIR::12 and DIR::last (for DIR/frames.h5) mean; nothing if the word
/// has no "::", or is the name of a file.
/// throws  InputError for other words behind "::"
[[nodiscard]] std::optional<FramePointer> frame_pointer(const std::filesystem::path& word);

/// The columns of one frame.
/// throws  InputError, with the file: no such file, no such frame, damaged
[[nodiscard]] std::unique_ptr<ArrayFile> open_frame(const FramePointer&);

}  // namespace vortree::io
