#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "flow/columns.hpp"
#include "io/input_error.hpp"

namespace vortree::io {

/// One saved moment of a run.
///
/// columns  of the particles, all of one length; x and y are among them
/// state    everything else that the solver needs to go on bit for bit, by name
struct Frame {
  std::int64_t step = 0;
  double time = 0;
  flow::Columns columns{};
  flow::State state{};

  std::size_t particles() const { return columns.empty() ? 0 : columns.front().values.size(); }
  bool operator==(const Frame&) const = default;
};

/// What a frames file says of its run, as attributes on its root.
struct RunInfo {
  std::string version;                 ///< of the program
  std::string scene_path;              ///< as the user gave it
  std::string scene;                   ///< text of the scene file, to the letter
  std::string resolved;                ///< the scene with every default written out
  std::vector<std::string> overrides;  ///< of the command line
  std::int64_t seed = 1;
  std::string units;
  bool operator==(const RunInfo&) const = default;
};

/// Starts DIR/frames.h5 (and DIR/frames.xdmf) with no frames; replaces older ones. DIR is created
/// if need be.
///
/// columns  of the particles that frames will have; their values do not count
///
/// Layout: the run as attributes of the root with a checksum over them, the dimensions of the
/// columns as attributes of the group `units`; a group `frame_000025` (step number) for each frame
/// with a dataset a column, attributes step, time, columns (names and units, in order), checksum
/// and the subgroups `state` and `view`, the latter the same columns once more as frames.xdmf shows
/// them (points and, if there are u and v, velocity in rows of three, vertices; 52 bytes a
/// particle). What the root needs lies at the beginning of the file, each frame in one piece behind
/// the frame before it: a file cut anywhere keeps the frames that lie before the cut. This holds
/// for runs of up to 4096 frames; more are no error, but then a cut can cost them all (a kill still
/// costs only one).
///
/// throws  InputError if DIR cannot be created or written
void create_frames(const std::filesystem::path& dir, const RunInfo&,
                   const flow::Columns& columns = {});

/// Appends a frame to DIR/frames.h5 and rewrites DIR/frames.xdmf. The file is opened and closed
/// each time, and the frame is linked into it only when it is on the disk: a kill loses at most
/// this frame.
///
/// throws  std::invalid_argument if the columns differ in length or the file has that step already,
///         std::runtime_error if it cannot be written, or the frame before is not what it was
void append_frame(const std::filesystem::path& dir, const Frame&);

/// A frames file of one frame, in the place of an older file in one rename; without frames.xdmf.
///
/// throws  std::invalid_argument if the columns differ in length, InputError if the file cannot be
///         written there, std::runtime_error if it could not
void write_frames(const std::filesystem::path& file, const RunInfo&, const Frame&);

/// What a frames file, healthy or not, still holds.
struct RecoveredFrames {
  RunInfo info;
  std::vector<std::int64_t> steps;  ///< of the frames found good, ascending
  std::optional<Frame> last;        ///< the last good one; none if nothing is left
  std::string warning;              ///< one sentence on what was lost; empty if the file is healthy
};

/// Reads the last good frame of a frames file, even if the file is cut short or frames of it are
/// damaged (checksum).
///
/// The file itself is not touched; a cut file is read from a temporary copy beside it, or in the
/// temporary folder of the system.
///
/// throws  InputError if there is no such file, if it never was a frames file, or if what it says
///         of its run does not agree with its checksum; other damage is not an error: `warning`
///         tells it and `last` may be empty
[[nodiscard]] RecoveredFrames read_last_good(const std::filesystem::path& file);

/// What the file says of its run, without a look at its frames.
/// throws  InputError as read_last_good, and if damage has left nothing of it
[[nodiscard]] RunInfo info_of_frames(const std::filesystem::path& file);

/// Shows the good frames of a file, healthy or not, up to and including `step`, by ascending step.
/// throws  InputError as read_last_good
void visit_frames(const std::filesystem::path& file, std::int64_t step,
                  const std::function<void(const Frame&)>& visit);

/// Makes DIR/frames.h5 healthy again and ready to continue behind `step`: keeps the good frames up
/// to and including it, drops the rest. The new file takes the place of the old one in one rename.
/// frames.xdmf follows.
///
/// throws  std::invalid_argument if there is no good frame `step`, std::runtime_error if the new
///         file cannot be written
void rewind_frames(const std::filesystem::path& dir, std::int64_t step);

}  // namespace vortree::io
