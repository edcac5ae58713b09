#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "io/input_error.hpp"

namespace vortree::io {

/// A CSV file with one header line, written row by row; every number in the shortest form that
/// reads back to the same double.
class Report {
 public:
  /// Starts a new file. throws InputError if it cannot be written.
  Report(std::filesystem::path, std::vector<std::string> columns);

  /// Goes on with an old file whose first column is the time: keeps its header and the whole rows
  /// with time <= `until`; a last line cut short by a kill is dropped. A missing or empty file is
  /// started anew.
  /// throws  InputError if the header names other columns
  [[nodiscard]] static Report resume(std::filesystem::path, std::vector<std::string> columns,
                                     double until);

  /// Writes and flushes one row.
  /// throws  std::invalid_argument if it has not one value for each column, std::runtime_error if
  ///         it cannot be written
  void row(std::span<const double> values);

 private:
  struct Continue {};
  Report(Continue, std::filesystem::path, std::vector<std::string> columns);
  void open();

  std::filesystem::path path_;
  std::vector<std::string> columns_;
  std::ofstream out_;
};

}  // namespace vortree::io
