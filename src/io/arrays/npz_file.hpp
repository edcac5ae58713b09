#pragma once

#include <filesystem>
#include <memory>

#include "io/arrays/array_file.hpp"

namespace vortree::io {

/// The arrays of an .npz file: a zip file, stored or deflated, of .npy files.
///
/// throws  InputError if it cannot be opened; BadArray as zip_members, bytes_of, read_npy_header
[[nodiscard]] std::unique_ptr<ArrayFile> open_npz(const std::filesystem::path&);

}  // namespace vortree::io
