#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "app/folder/run_tables.hpp"
#include "flow/solver.hpp"
#include "io/frames/frames.hpp"
#include "io/scene/scene.hpp"
#include "io/tables/fields.hpp"

namespace vortree::app {

/// What a run writes into its folder on its way; cases/scenes.md says what the files hold. Scene
/// and solver are those of the run, which keeps them.
///
/// Every frame is a checkpoint, and whatever was written before it is on the disk before it: rows
/// of the tables and pictures are forced to the disk, then the frame. So after a kill or a power
/// failure at any moment the last frame that agrees with its checksum has all that belongs before
/// it; what is later is dropped and made again. frames.xdmf only repeats frames.h5, outline.csv the
/// scene: they are not waited for. A new run first takes summary.json away, then empties frames.h5,
/// then the rest: no summary ever stands beside frames of another run.
class RunFiles {
 public:
  RunFiles(const io::Scene& scene, const flow::Solver& solver, RowNames names,
           std::filesystem::path folder);

  /// throws  io::InputError if one of them is an input, or no regular file
  void require_outputs() const;

  /// Starts them, in place of older ones.
  void begin();

  /// The frame to go on from; says on standard error what was lost behind it.
  /// throws  io::InputError if there is none, if it was run with a scene that differs in more than
  ///         its end, [output] and [check], or if its time is not that of its step
  [[nodiscard]] io::Frame last_frame() const;

  /// Goes on behind that frame: what is later is dropped, since it will be made again. Says on
  /// standard error what is lost of what is earlier, or had to be made again.
  /// throws  io::InputError if a table cannot be made again
  void resume(const io::Frame& frame);

  void row(std::span<const double> values);
  void probed(std::span<const double> rows) { tables_.rows(RunTables::probes, rows); }
  void field(const io::Field& field);

  /// The flow as it is, with whatever else it takes to go on; and the rows that the method adds to
  /// its table.
  /// throws  flow::Diverged if a number is not finite
  void frame(flow::State state);

  /// Forces the last rows to the disk.
  void end() const { tables_.force(); }

 private:
  void outline() const;
  void resume_fields(const io::Frame& frame);

  const io::Scene& scene_;
  const flow::Solver& solver_;
  std::filesystem::path folder_;
  RunTables tables_;
  std::vector<double> fields_;  ///< times of the pictures so far, but for those that are lost
};

/// The scene that a run was run with, read as `now` is: by the same name, with the same methods.
/// throws  io::InputError, with the name of the frames file, if it does not say
[[nodiscard]] io::Scene scene_of_frames(const std::filesystem::path& frames, const io::Scene& now);

}  // namespace vortree::app
