#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/descriptor.hpp"
#include "io/input_error.hpp"
#include "io/tables/table_mark.hpp"

namespace vortree::io {

/// A CSV file with one header line, written row by row; every number in the shortest form that
/// reads back to the same double. A row is with the system as soon as it is written, on the disk
/// after force().
class Report {
 public:
  /// Starts a new file. throws InputError if it cannot be written.
  Report(std::filesystem::path, std::vector<std::string> columns);

  /// A file that has these rows and no others, in place of what is there.
  Report(std::filesystem::path, std::vector<std::string> columns, std::span<const double> rows);

  /// Goes on with an old file behind a mark; what is later is dropped. Nothing if the file is not
  /// there or what stands before the mark is not what it was made of.
  /// throws  InputError if the header names other columns, or if it cannot be written
  [[nodiscard]] static std::optional<Report> resume(std::filesystem::path,
                                                    std::vector<std::string> columns,
                                                    const TableMark&);

  /// Writes one row.
  /// throws  std::invalid_argument if it has not one value for each column, std::runtime_error if
  ///         it cannot be written, or if someone else has removed or changed the file meanwhile
  void row(std::span<const double> values);

  /// Forces all rows to the disk. throws std::runtime_error
  void force() const;

  [[nodiscard]] const TableMark& mark() const { return mark_; }

  /// The rows since the last call, one after another.
  [[nodiscard]] std::vector<double> take_rows() { return std::exchange(since_, {}); }

 private:
  Report(std::filesystem::path, std::vector<std::string> columns, const TableMark&);
  void require_alone() const;

  std::filesystem::path path_;
  std::vector<std::string> columns_;
  TableMark mark_;
  std::vector<double> since_;
  Descriptor file_;
};

/// What a report of these columns and rows would be marked with; nothing if there are no whole
/// rows.
[[nodiscard]] std::optional<TableMark> mark_of_rows(const std::vector<std::string>& columns,
                                                    std::span<const double> rows);

}  // namespace vortree::io
