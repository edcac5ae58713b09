#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/frames/frames.hpp"
#include "io/tables/report.hpp"

namespace vortree::app {

/// The tables that a run writes row by row: report.csv, and wall.csv beside a wall or energy.csv in
/// free space.
///
/// A frame keeps of each table the rows since the frame before it, and a mark (rows, bytes,
/// checksum) of all its text up to there. So a resumed run notices whatever became of a table, and
/// makes it again from the frames.
class RunTables {
 public:
  enum Kind : std::size_t { report, other };

  RunTables(std::filesystem::path folder, bool wall);

  /// Their names in the folder.
  [[nodiscard]] std::array<std::string, 2> names() const;

  /// Starts them, in place of older ones.
  void begin();

  /// Goes on behind a frame; says on standard error which table had to be made again.
  ///
  /// expected  for frames of earlier versions, which keep nothing of a table: the times of its rows
  /// throws    io::InputError if a table is not what it was and the frames lack rows to make it
  ///           again
  using Times = std::function<std::vector<double>(Kind)>;
  void resume(const io::Frame& frame, const Times& expected);

  void row(Kind kind, std::span<const double> values) { open_[kind]->row(values); }

  /// Forces all rows to the disk.
  void force() const;

  /// Forces all rows to the disk and tells the frame of them.
  void keep(io::Frame& frame);

 private:
  std::filesystem::path path(Kind kind) const { return folder_ / names()[kind]; }
  io::Report resumed(Kind kind, const io::Frame& frame, const Times& expected) const;
  std::vector<double> rows_in_frames(Kind kind, const io::Frame& last) const;
  io::Report made_again(Kind kind, const io::Frame& last, const io::TableMark& mark) const;

  std::filesystem::path folder_;
  bool wall_;
  std::array<std::optional<io::Report>, 2> open_;
};

}  // namespace vortree::app
