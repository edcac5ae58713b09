#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/input_error.hpp"

namespace vortree::io {

/// A CSV file of numbers: one line of column names, then rows. Lines that begin with # and empty
/// lines are notes; an empty cell is NaN.
class Table {
 public:
  /// only    columns that are read, if there are such; what stands in others is passed over. Empty:
  ///         all
  /// throws  InputError: no such file, no line of names, `file:line: ...` for a row with too few or
  ///         too many cells or a cell that is no number
  explicit Table(const std::filesystem::path& file, std::span<const std::string_view> only = {});

  [[nodiscard]] std::size_t rows() const { return lines_.size(); }
  /// Where a row stands in the file, counted from 1.
  [[nodiscard]] int line_of(std::size_t row) const { return lines_[row]; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] bool has(std::string_view column) const;

  /// One column that is read, a value a row. throws InputError with the columns there are if there
  /// is none such.
  [[nodiscard]] std::vector<double> column(std::string_view name) const;

 private:
  void take_names(std::string_view line, std::span<const std::string_view> only);
  void take_row(std::string_view line, int line_number);

  std::filesystem::path file_;
  std::vector<std::string> names_;
  std::vector<std::size_t> read_;  // places among the names of those that are read
  std::vector<int> lines_;         // of the rows
  std::vector<double> values_;     // row by row, of those that are read
};

/// The number a text spells from end to end ("nan" and "inf" too, blanks around it and
/// a plus before it allowed).
[[nodiscard]] std::optional<double> number(std::string_view text);

}  // namespace vortree::io
