#include "io/frames/frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "io/files.hpp"
#include "io/frames/file.hpp"
#include "io/frames/group.hpp"
#include "io/frames/recovered.hpp"
#include "io/frames/xdmf.hpp"

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

fs::path frames_path(const fs::path& dir) {
  return dir / "frames.h5";
}

void require_equal_lengths(const Frame& frame) {
  for (const flow::Column& column : frame.columns)
    if (column.values.size() != frame.particles())
      throw std::invalid_argument(fmt::format("frame {}: {} has {} values, {} has {}", frame.step,
                                              column.name, column.values.size(),
                                              frame.columns.front().name, frame.particles()));
}

fs::path xdmf_path(const fs::path& dir) {
  return dir / "frames.xdmf";
}

void refresh_xdmf(const fs::path& dir) {
  const h5::Handle file = h5::open_file(frames_path(dir));
  std::vector<FrameLabel> labels;
  for (const FramePlace& place : frame_places(file)) labels.push_back(read_label(file, place));
  write_derived_text(xdmf_path(dir), xdmf_text("frames.h5", labels));
}

void continue_xdmf(const fs::path& dir, const Frame& frame) {
  const FrameLabel label = label_of(frame);
  std::string page = fs::exists(xdmf_path(dir)) ? read_text(xdmf_path(dir)) : "";
  if (add_to_xdmf(page, "frames.h5", label)) {
    write_derived_text(xdmf_path(dir), page);
  } else {
    refresh_xdmf(dir);
  }
}

std::optional<Frame> read_if_good(hid_t file, const FramePlace& place) {
  try {
    return read_frame(file, place);
  } catch (const h5::NotTheFile& refused) {
    throw std::runtime_error(fmt::format("{}: {}: {}; nothing was changed", h5::file_name(file),
                                         frame_name(place.step), refused.what()));
  } catch (const h5::Failure&) {
    return std::nullopt;
  }
}

/// A file that was emptied while a frame was added to it is whole again but for the frames before.
void require_last_frame(hid_t file) {
  const std::vector<FramePlace> places = frame_places(file);
  if (!places.empty() && !read_if_good(file, places.back()))
    throw std::runtime_error(fmt::format("{}: {} is no longer what was written",
                                         h5::file_name(file), frame_name(places.back().step)));
}

/// Reads frames from the last to the first, so that the first good one met is the last.
RecoveredFrames take_stock(hid_t file) {
  RecoveredFrames found;
  const std::vector<FramePlace> places = frame_places(file);
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    std::optional<Frame> frame = read_if_good(file, *place);
    if (!frame) continue;
    found.steps.push_back(frame->step);
    if (!found.last) found.last = std::move(frame);
  }
  std::reverse(found.steps.begin(), found.steps.end());
  return found;
}

std::string told_steps(const std::vector<std::int64_t>& steps) {
  if (steps.size() == 1) return fmt::format("the frame of step {} is lost", steps[0]);
  return fmt::format("{} frames of steps {} to {} are lost", steps.size(), steps.front(),
                     steps.back());
}

std::string warning_of(const fs::path& path, const MendedFile& opened,
                       const RecoveredFrames& found) {
  std::vector<std::int64_t> lost;
  if (opened.file >= 0) {
    for (const FramePlace& place : frame_places(opened.file)) {
      const bool good = std::binary_search(found.steps.begin(), found.steps.end(), place.step);
      if (!good) lost.push_back(place.step);
    }
  }
  if (lost.empty() && opened.wound.empty()) return {};
  const std::string last = found.last ? fmt::format("the last good frame is step {}, t = {}",
                                                    found.last->step, found.last->time)
                                      : "no good frame is left in it";
  return fmt::format("{} {}: {}{}", path.string(),
                     opened.wound.empty() ? "is damaged" : opened.wound,
                     lost.empty() ? "" : told_steps(lost) + "; ", last);
}

/// Nothing if the file is damaged where it says it.
std::optional<RunInfo> info_of(const fs::path& path, const MendedFile& opened) {
  try {
    if (opened.file < 0) return std::nullopt;
    RunInfo info = read_run_info(opened.file);
    if (agrees_with_checksum(opened.file, info)) return info;
    throw InputError(path.string() +
                     " is damaged: what it says of its run does not agree with its checksum");
  } catch (const h5::NotTheFile& refused) {
    throw std::runtime_error(fmt::format("{}: {}", path.string(), refused.what()));
  } catch (const h5::Failure& failure) {
    if (opened.wound.empty()) {
      throw InputError(fmt::format("{} is HDF5 but no frames file: its attribute {} is missing",
                                   path.string(), failure.what()));
    }
  }
  return std::nullopt;
}

}  // namespace

void create_frames(const fs::path& dir, const RunInfo& info, const flow::Columns& columns) {
  std::error_code error;
  fs::create_directories(dir, error);
  require_writable(frames_path(dir));
  h5::replace_file(frames_path(dir),
                   [&](const fs::path& fresh) { write_empty_frames(fresh, info, columns); });
  write_derived_text(xdmf_path(dir), xdmf_text("frames.h5", {}));
}

void write_frames(const fs::path& file, const RunInfo& info, const Frame& frame) {
  require_equal_lengths(frame);
  require_writable(file);
  h5::replace_file(file, [&](const fs::path& fresh) {
    write_empty_frames(fresh, info, frame.columns);
    h5::Handle opened = h5::open_file(fresh, H5F_ACC_RDWR);
    write_frame(opened, frame);
    h5::close_file(std::move(opened), fresh);
  });
}

void append_frame(const fs::path& dir, const Frame& frame) {
  require_equal_lengths(frame);
  const fs::path path = frames_path(dir);
  try {
    h5::Handle file = h5::open_file(path, H5F_ACC_RDWR);
    if (h5::has(file, frame_name(frame.step))) {
      throw std::invalid_argument(
          fmt::format("{} has a frame of step {} already", path.string(), frame.step));
    }
    require_last_frame(file);
    write_frame(file, frame);
    h5::close_file(std::move(file), path);
    continue_xdmf(dir, frame);
  } catch (const h5::Failure& failure) {
    throw std::runtime_error(fmt::format("{}: the frame of step {} cannot be saved ({})",
                                         path.string(), frame.step, failure.what()));
  }
}

RunInfo info_of_frames(const fs::path& path) {
  const MendedFile opened = open_mended(path);
  std::optional<RunInfo> info = info_of(path, opened);
  if (info) return *std::move(info);
  throw InputError(
      fmt::format("{} {}: what it says of its run is lost", path.string(), opened.wound));
}

RecoveredFrames read_last_good(const fs::path& path) {
  const MendedFile opened = open_mended(path);
  RunInfo info = info_of(path, opened).value_or(RunInfo{});
  RecoveredFrames found = opened.file >= 0 ? take_stock(opened.file) : RecoveredFrames{};
  found.info = std::move(info);
  found.warning = warning_of(path, opened, found);
  return found;
}

void visit_frames(const fs::path& path, std::int64_t step,
                  const std::function<void(const Frame&)>& visit) {
  const MendedFile opened = open_mended(path);
  if (opened.file < 0) return;
  for (const FramePlace& place : frame_places(opened.file)) {
    if (place.step > step) break;
    if (const auto frame = read_if_good(opened.file, place)) visit(*frame);
  }
}

void rewind_frames(const fs::path& dir, std::int64_t step) {
  const fs::path path = frames_path(dir);
  const RunInfo info = info_of_frames(path);
  h5::replace_file(path, [&](const fs::path& fresh) {
    h5::Handle healthy;
    bool met = false;
    visit_frames(path, step, [&](const Frame& frame) {
      if (healthy < 0) {
        write_empty_frames(fresh, info, frame.columns);
        healthy = h5::open_file(fresh, H5F_ACC_RDWR);
      }
      write_frame(healthy, frame);
      met = frame.step == step;
    });
    if (!met) {
      throw std::invalid_argument(
          fmt::format("{} has no good frame of step {}", path.string(), step));
    }
    h5::close_file(std::move(healthy), fresh);
  });
  refresh_xdmf(dir);
}

}  // namespace vortree::io
