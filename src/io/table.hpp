#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/input_error.hpp"

namespace vortree::io {

/// A CSV of numbers: the header, then rows. Lines beginning with # and empty lines are skipped; an
/// empty cell is NaN.
struct Table {
  std::filesystem::path path;
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;

  /// One column by name. throws InputError naming the file and the columns there are.
  [[nodiscard]] std::vector<double> column(const std::string& name) const;
};

/// throws  InputError: no such file, no header, `file:line: ...` for a row with too few or too many
///         cells or a cell that is no number
[[nodiscard]] Table read_table(const std::filesystem::path&);

/// The number a text spells from end to end ("nan" and "inf" too, blanks around it allowed).
[[nodiscard]] std::optional<double> number(std::string_view text);

}  // namespace vortree::io
