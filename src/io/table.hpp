#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/input_error.hpp"

namespace vortree::io {

/// A CSV file of numbers: one line of column names, then rows; lines that begin with # are notes.
class Table {
 public:
  /// throws  InputError naming file and line if it is missing, or a row is not numbers, one a column
  explicit Table(const std::filesystem::path& file);

  std::size_t rows() const { return values_.size() / names_.size(); }
  bool has(std::string_view column) const;

  /// throws  InputError if there is no such column
  std::vector<double> column(std::string_view name) const;

 private:
  std::filesystem::path file_;
  std::vector<std::string> names_;
  std::vector<double> values_;  // row by row
};

}  // namespace vortree::io
