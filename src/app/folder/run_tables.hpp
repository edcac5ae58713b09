#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "flow/solver.hpp"
#include "io/frames/frames.hpp"
#include "io/tables/report.hpp"

namespace vortree::app {

/// Columns of report.csv, and of probes.csv, if there is one.
struct RowNames {
  std::vector<std::string> report, probes{};
};

/// The tables that a run writes row by row: report.csv, that which its method keeps with the
/// frames, and probes.csv, if it has columns.
///
/// A frame keeps of each table the rows since the frame before it, and a mark (rows, bytes,
/// checksum) of all its text up to there. So a resumed run notices whatever became of a table, and
/// makes it again from the frames.
class RunTables {
 public:
  enum Kind : std::size_t { report, of_frames, probes };

  RunTables(std::filesystem::path folder, RowNames names, const flow::FrameTable& of_frames);

  /// Their names in the folder.
  [[nodiscard]] std::vector<std::string> names() const;

  /// Starts them, in place of older ones.
  void begin();

  /// Goes on behind a frame; says on standard error which table had to be made again.
  /// throws    io::InputError if a table is not what it was and the frames lack rows to make it
  ///           again
  void resume(const io::Frame& frame);

  void row(Kind kind, std::span<const double> values) { open_[kind]->row(values); }

  /// Several rows, one after another.
  void rows(Kind kind, std::span<const double> values);

  /// Forces all rows to the disk.
  void force() const;

  /// Forces all rows to the disk and tells the frame of them.
  void keep(io::Frame& frame);

 private:
  std::vector<Kind> kinds() const;
  std::filesystem::path path(Kind kind) const { return folder_ / tables_[kind].name; }
  io::Report resumed(Kind kind, const io::Frame& frame) const;
  std::vector<double> rows_in_frames(Kind kind, const io::Frame& last) const;
  io::Report made_again(Kind kind, const io::Frame& last, const io::TableMark& mark) const;

  std::filesystem::path folder_;
  std::vector<flow::FrameTable> tables_;
  std::vector<std::optional<io::Report>> open_;
};

}  // namespace vortree::app
