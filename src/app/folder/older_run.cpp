#include "app/folder/older_run.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "app/install_paths.hpp"
#include "app/plot.hpp"
#include "io/files.hpp"
#include "io/frames/frames.hpp"
#include "io/frames/read.hpp"
#include "io/input_error.hpp"
#include "io/tables/fields.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array tables{"report.csv", "wall.csv", "energy.csv"};

bool has_rows(const fs::path& table, int more_than = 0) {
  if (!fs::is_regular_file(table)) return false;
  std::ifstream in(table);
  std::string line;
  for (int k = -1; k <= more_than; ++k)
    if (!std::getline(in, line)) return false;
  return true;
}

[[noreturn]] void refuse_older(const fs::path& file) {
  throw io::InputError(fmt::format(
      "{} is there already: --overwrite replaces it, --out DIR leaves it alone", file.string()));
}

/// What frames.h5 holds, in words; nothing if it is healthy and has no frame yet.
std::optional<std::string> frames_in(const fs::path& file) {
  try {
    const io::FramesLabel label = io::label_of_frames(file);
    if (label.frames == 0) {
      (void)io::info_of_frames(file);  // refused if no run has written it
      return std::nullopt;
    }
    return fmt::format("a run of {} frame{} to t = {:g}", label.frames,
                       label.frames == 1 ? "" : "s", label.last_time);
  } catch (const io::InputError&) {
    return "a run whose frames.h5 is damaged or no frames file";
  }
}

/// Whether probes.csv has rows of later than the start.
bool probed_later(const fs::path& table) {
  if (!fs::is_regular_file(table)) return false;
  std::ifstream in(table);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line))
    if (!line.starts_with("0,")) return true;
  return false;
}

/// A figure, a page or a video; not what a link of its name leads to, if that is of another kind.
void remove_shown(const fs::path& file) {
  if (io::keeps_suffix(file)) io::remove_file(file);
}

bool is_picture_of_start(const fs::path& folder) {
  try {
    return io::field_times(folder) == std::vector{0.0};
  } catch (const io::InputError&) {
    return false;
  }
}

/// A run that was stopped before its first frame has left its frames.h5, tables of a row at most,
/// and probes and a picture of the start. All else is none of its.
void refuse_more_than_a_start(const fs::path& folder) {
  for (const char* name : tables)
    if (has_rows(folder / name, 1)) refuse_older(folder / name);
  if (probed_later(folder / "probes.csv")) refuse_older(folder / "probes.csv");
  const bool pictured = fs::exists(folder / "fields.h5");
  if (pictured && !is_picture_of_start(folder)) refuse_older(folder / "fields.h5");
  if (!pictured && fs::exists(folder / "fields.xdmf")) refuse_older(folder / "fields.xdmf");
  if (fs::exists(folder / "summary.json")) refuse_older(folder / "summary.json");
}

}  // namespace

void require_frames(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw io::InputError(fmt::format("{}: no such folder", folder.string()));
  if (!fs::exists(folder / "frames.h5", error))
    throw io::InputError(fmt::format("{}: no run has left frames.h5 there", folder.string()));
}

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
    return refuse_more_than_a_start(folder);
  }
  for (const char* name : tables) refuse_older_table(folder / name);
  refuse_older_table(folder / "probes.csv");
  for (const char* name : {"summary.json", "fields.h5", "fields.xdmf", "frames.xdmf", "outline.csv",
                           "lyapunov.h5", "lyapunov.xdmf"})
    if (fs::is_regular_file(folder / name)) refuse_older(folder / name);
}

void refuse_older_table(const fs::path& table) {
  if (has_rows(table)) refuse_older(table);
}

void refuse_older_figures(const fs::path& folder, std::string_view kind,
                          std::span<const std::string> formats) {
  const std::array<std::string, 1> usual{"png"};
  for (const fs::path& script : plot_scripts(kind))
    for (const std::string& format :
         formats.empty() ? std::span<const std::string>(usual) : formats) {
      const fs::path figure = (folder / script.stem()).concat("." + format);
      if (fs::exists(fs::symlink_status(figure))) refuse_older(figure);
    }
}

void remove_older_figures(const fs::path& folder, std::string_view kind) {
  for (const fs::path& script : plot_scripts(kind))
    for (const std::string& format : figure_formats()) {
      const fs::path figure = (folder / script.stem()).concat("." + format);
      if (fs::is_regular_file(figure)) remove_shown(figure);
    }
}

void remove_older_tables_and_pictures(const fs::path& folder) {
  for (const char* name : tables) io::remove_file(folder / name);
  for (const char* name : {"probes.csv", "fields.h5", "fields.xdmf", "outline.csv", "lyapunov.h5",
                           "lyapunov.xdmf", "failed.txt"})
    io::remove_file(folder / name);
  for (const char* name : {"movie.mp4", "movie.webp", "movie.gif", "view.html"})
    remove_shown(folder / name);
  remove_older_figures(folder);
}

bool lacks_outline(const fs::path& folder) {
  const fs::path frames = folder / "frames.h5";
  std::error_code error;  // what is wrong with the folder is not said here
  if (!fs::exists(frames, error) || fs::exists(folder / "outline.csv", error)) return false;
  try {
    const std::string scene = io::info_of_frames(frames).resolved;
    return scene.find("\n[body]\n") != std::string::npos ||
           scene.find("\n[[body]]\n") != std::string::npos;
  } catch (const io::InputError&) {
    return false;
  }
}

}  // namespace vortree::app
