#include "app/folder/older_run.hpp"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <string>

#include "io/frames/read.hpp"
#include "io/input_error.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

bool has_rows(const fs::path& table) {
  if (!fs::is_regular_file(table)) return false;
  std::ifstream in(table);
  std::string names, row;
  return std::getline(in, names) && std::getline(in, row);
}

[[noreturn]] void refuse_older(const fs::path& file) {
  throw io::InputError(fmt::format(
      "{} is there already: --overwrite replaces it, --out DIR leaves it alone", file.string()));
}

/// What frames.h5 holds, in words; nothing if it is healthy and has no frame yet.
std::optional<std::string> frames_in(const fs::path& file) {
  try {
    const io::FramesLabel label = io::label_of_frames(file);
    if (label.frames == 0) return std::nullopt;
    return fmt::format("a run of {} frame{} to t = {:g}", label.frames,
                       label.frames == 1 ? "" : "s", label.last_time);
  } catch (const io::InputError&) {
    return "a run whose frames.h5 is damaged or no frames file";
  }
}

}  // namespace

bool holds_frames(const fs::path& folder) {
  const fs::path file = folder / "frames.h5";
  return fs::exists(file) && frames_in(file);
}

void refuse_older_run(const fs::path& folder) {
  const fs::path file = folder / "frames.h5";
  if (fs::exists(file)) {
    if (const auto frames = frames_in(file))
      throw io::InputError(
          fmt::format("{} holds {} already: --resume goes on with it, --overwrite replaces it, "
                      "--out DIR leaves it alone",
                      folder.string(), *frames));
    return;  // a run that was stopped before its first frame
  }
  for (const char* name : {"report.csv", "wall.csv", "energy.csv"})
    refuse_older_table(folder / name);
  for (const char* name : {"summary.json", "fields.h5"})
    if (fs::is_regular_file(folder / name)) refuse_older(folder / name);
}

void refuse_older_table(const fs::path& table) {
  if (has_rows(table)) refuse_older(table);
}

}  // namespace vortree::app
