#include "app/folder/run_tables.hpp"

#include <fmt/format.h>

#include "app/say.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view way_out = "put the table back as it was, or start anew with --overwrite";

/// Names in the state of a frame.
std::string mark_key(const std::string& table) {
  return "mark of " + table;
}
std::string rows_key(const std::string& table) {
  return "rows of " + table;
}

}  // namespace

RunTables::RunTables(fs::path folder, RowNames names, const flow::FrameTable& of_frames)
    : folder_(std::move(folder)), tables_{{"report.csv", std::move(names.report)}, of_frames} {
  if (!names.probes.empty()) tables_.push_back({"probes.csv", std::move(names.probes)});
  open_.resize(tables_.size());
}

std::vector<RunTables::Kind> RunTables::kinds() const {
  std::vector<Kind> all{report, of_frames};
  if (tables_.size() > probes) all.push_back(probes);
  return all;
}

std::vector<std::string> RunTables::names() const {
  std::vector<std::string> names;
  for (const flow::FrameTable& table : tables_) names.push_back(table.name);
  return names;
}

void RunTables::begin() {
  for (const Kind kind : kinds()) open_[kind].emplace(path(kind), tables_[kind].columns);
}

void RunTables::rows(Kind kind, std::span<const double> values) {
  if (values.empty()) return;
  const std::size_t width = tables_[kind].columns.size();
  for (std::size_t k = 0; k < values.size(); k += width) row(kind, values.subspan(k, width));
}

void RunTables::resume(const io::Frame& frame) {
  for (const Kind kind : kinds()) open_[kind] = resumed(kind, frame);
}

io::Report RunTables::resumed(Kind kind, const io::Frame& frame) const {
  const auto mark = io::mark_of(flow::saved(frame.state, mark_key(tables_[kind].name)));
  if (!mark) throw std::out_of_range("no mark of " + tables_[kind].name);
  auto report = io::Report::resume(path(kind), tables_[kind].columns, *mark);
  return report ? *std::move(report) : made_again(kind, frame, *mark);
}

std::vector<double> RunTables::rows_in_frames(Kind kind, const io::Frame& last) const {
  std::vector<double> rows;
  io::visit_frames(folder_ / "frames.h5", last.step, [&](const io::Frame& frame) {
    const auto kept = frame.state.find(rows_key(tables_[kind].name));
    if (kept != frame.state.end())
      rows.insert(rows.end(), kept->second.begin(), kept->second.end());
  });
  return rows;
}

io::Report RunTables::made_again(Kind kind, const io::Frame& last,
                                 const io::TableMark& mark) const {
  const std::vector<std::string>& names = tables_[kind].columns;
  std::string what = path(kind).string() + " is gone";
  if (fs::exists(path(kind)))
    what = fmt::format("{} is not what it was when the frame of step {} was saved",
                       path(kind).string(), last.step);
  const std::vector<double> rows = rows_in_frames(kind, last);
  if (io::mark_of_rows(names, rows) != mark)
    throw io::InputError(
        fmt::format("{}, and frames.h5 lacks rows to make it again; {}", what, way_out));
  say("{}; it is made again from frames.h5", what);
  return io::Report(path(kind), names, rows);
}

void RunTables::force() const {
  for (const auto& table : open_) table->force();
}

void RunTables::keep(io::Frame& frame) {
  force();
  for (const Kind kind : kinds()) {
    frame.state[mark_key(tables_[kind].name)] = io::as_numbers(open_[kind]->mark());
    frame.state[rows_key(tables_[kind].name)] = open_[kind]->take_rows();
  }
}

}  // namespace vortree::app
