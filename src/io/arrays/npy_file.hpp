#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/arrays/array_file.hpp"

namespace vortree::io {

/// The columns of an .npy file: of rows of numbers, named by their order, or of records by their
/// own names.
///
/// in_order  what the columns of rows are
/// throws    InputError if it cannot be opened; BadArray as read_npy_header, for rows of fewer than
///           two numbers or more than there are names, no numbers
[[nodiscard]] std::unique_ptr<ArrayFile> open_npy(const std::filesystem::path&,
                                                  std::vector<std::string> in_order);

}  // namespace vortree::io
