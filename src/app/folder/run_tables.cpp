#include "app/folder/run_tables.hpp"

#include <fmt/format.h>

#include "app/say.hpp"
#include "flow/record.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array<RunTables::Kind, 2> kinds{RunTables::report, RunTables::other};

std::vector<std::string> columns(RunTables::Kind kind, bool wall) {
  if (kind == RunTables::report) return flow::Record::names();
  if (wall) return {"t", "T", "angle_deg", "vorticity", "sheet"};
  return {"t", "energy", "enstrophy"};
}

constexpr std::string_view way_out = "put the table back as it was, or start anew with --overwrite";

/// Names in the state of a frame.
std::string mark_key(const std::string& table) {
  return "mark of " + table;
}
std::string rows_key(const std::string& table) {
  return "rows of " + table;
}

std::optional<io::TableMark> mark_in(const io::Frame& frame, const std::string& table) {
  const auto kept = frame.state.find(mark_key(table));
  return kept == frame.state.end() ? std::nullopt : io::mark_of(kept->second);
}

}  // namespace

RunTables::RunTables(fs::path folder, bool wall) : folder_(std::move(folder)), wall_(wall) {}

std::array<std::string, 2> RunTables::names() const {
  return {"report.csv", wall_ ? "wall.csv" : "energy.csv"};
}

void RunTables::begin() {
  for (const Kind kind : kinds) open_[kind].emplace(path(kind), columns(kind, wall_));
}

void RunTables::resume(const io::Frame& frame, const Times& expected) {
  for (const Kind kind : kinds) open_[kind] = resumed(kind, frame, expected);
}

io::Report RunTables::resumed(Kind kind, const io::Frame& frame, const Times& expected) const {
  std::optional<io::TableMark> mark = mark_in(frame, names()[kind]);
  if (!mark) {
    try {
      mark = io::counted(path(kind), io::report_text(path(kind)), expected(kind));
    } catch (const io::InputError& differs) {
      throw io::InputError(fmt::format("{}; {}", differs.what(), way_out));
    }
  }
  auto report = io::Report::resume(path(kind), columns(kind, wall_), *mark);
  return report ? *std::move(report) : made_again(kind, frame, *mark);
}

std::vector<double> RunTables::rows_in_frames(Kind kind, const io::Frame& last) const {
  std::vector<double> rows;
  io::visit_frames(folder_ / "frames.h5", last.step, [&](const io::Frame& frame) {
    const auto kept = frame.state.find(rows_key(names()[kind]));
    if (kept != frame.state.end())
      rows.insert(rows.end(), kept->second.begin(), kept->second.end());
  });
  return rows;
}

io::Report RunTables::made_again(Kind kind, const io::Frame& last,
                                 const io::TableMark& mark) const {
  const std::vector<std::string> names = columns(kind, wall_);
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
  for (const Kind kind : kinds) {
    frame.state[mark_key(names()[kind])] = io::as_numbers(open_[kind]->mark());
    frame.state[rows_key(names()[kind])] = open_[kind]->take_rows();
  }
}

}  // namespace vortree::app
