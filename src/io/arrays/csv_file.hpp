#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "io/arrays/array_file.hpp"

namespace vortree::io {

/// The columns of a table of text (Table).
///
/// wanted  names of columns that are read; whatever stands in others cannot be wrong
/// throws  InputError, with the line: as Table, and for a first line of numbers instead of names
[[nodiscard]] std::unique_ptr<ArrayFile> open_csv(const std::filesystem::path&,
                                                  std::vector<std::string_view> wanted);

}  // namespace vortree::io
