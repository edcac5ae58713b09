#include "app/folder/run_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <stdexcept>

#include "app/folder/older_run.hpp"
#include "app/install_paths.hpp"
#include "app/say.hpp"
#include "io/files.hpp"
#include "io/frames/stored_scene.hpp"
#include "io/scene/reference.hpp"
#include "io/tables/outline.hpp"
#include "io/while_reading.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

const std::string fields_key = "times of fields";  // in the state of a frame

/// What can no longer be written in the middle of a run is nobody's input.
void on_the_way(const std::function<void()>& write) {
  try {
    write();
  } catch (const io::InputError& refused) {
    throw std::runtime_error(refused.what());
  }
}

}  // namespace

RunFiles::RunFiles(const io::Scene& scene, const flow::Solver& solver, RowNames names,
                   fs::path folder)
    : scene_(scene),
      solver_(solver),
      folder_(std::move(folder)),
      tables_(folder_, std::move(names), solver.frame_table()) {}

void RunFiles::require_outputs() const {
  std::vector<fs::path> inputs{scene_.origin.path};
  for (const auto& reference :
       {scene_.check.drag_reference, scene_.check.lift_reference,
        scene_.check.wall_vorticity_reference, scene_.check.front_pressure_reference,
        scene_.check.moments_reference})
    if (reference) inputs.push_back(io::reference_path(scene_, *reference));
  for (const body::BodySettings& body : flow::every_body(scene_))
    for (const auto& file : {body.file, body.motion ? body.motion->file : std::nullopt})
      if (file) inputs.push_back(io::reference_path(scene_, *file));
  if (scene_.motion && scene_.motion->file)
    inputs.push_back(io::reference_path(scene_, *scene_.motion->file));
  std::vector<std::string> names = tables_.names();
  for (const char* name :
       {"frames.h5", "frames.xdmf", "fields.h5", "fields.xdmf", "outline.csv", "summary.json"})
    names.emplace_back(name);
  std::map<fs::path, fs::path> targets;
  for (const std::string& name : names) {
    const fs::path output = folder_ / name;
    io::require_writable(output, inputs);
    if (const auto [at, fresh] = targets.emplace(io::target_of(output), output); !fresh)
      throw io::InputError(fmt::format("{} leads to the same file as {}; each output needs its own",
                                       output.string(), at->second.string()));
  }
}

void RunFiles::begin() {
  require_outputs();
  io::remove_file(folder_ / "summary.json");
  io::create_frames(folder_, io::info_of(scene_, version()), solver_.columns());
  remove_older_tables_and_pictures(folder_);
  outline();
  tables_.begin();
}

void RunFiles::outline() const {
  if (scene_.body) io::write_outlines(folder_ / "outline.csv", flow::every_body(scene_));
}

io::Frame RunFiles::last_frame() const {
  const fs::path file = folder_ / "frames.h5";
  const io::WhileReading reading(file);
  io::RecoveredFrames found = io::read_last_good(file);
  if (!found.warning.empty()) say_line(found.warning);
  if (!found.last) throw io::InputError(fmt::format("{}: no frame to go on from", file.string()));
  io::hold_scene(io::stored_scene(found.info, file, scene_.origin.path, scene_.methods), scene_,
                 file);
  io::hold_time(*found.last, scene_.time.dt, file);
  return *std::move(found.last);
}

io::Scene scene_of_frames(const fs::path& frames, const io::Scene& now) {
  return io::stored_scene(io::info_of_frames(frames), frames, now.origin.path, now.methods);
}

void RunFiles::resume_fields(const io::Frame& frame) {
  const std::vector<double> kept = io::rewind_fields(folder_, frame.time);
  fields_ = flow::saved(frame.state, fields_key);
  std::vector<double> lost;
  std::ranges::copy_if(fields_, std::back_inserter(lost),
                       [&](double t) { return std::ranges::find(kept, t) == kept.end(); });
  if (!lost.empty())
    say("{}: the pictures of t = {} are lost, and are not made again",
        (folder_ / "fields.h5").string(), fmt::join(lost, ", "));
  std::erase_if(fields_, [&](double t) { return std::ranges::find(lost, t) != lost.end(); });
}

void RunFiles::resume(const io::Frame& frame) {
  require_outputs();
  outline();
  tables_.resume(frame);
  resume_fields(frame);
  io::rewind_frames(folder_, frame.step);
}

void RunFiles::row(std::span<const double> values) {
  tables_.row(RunTables::report, values);
}

void RunFiles::frame(flow::State state) {
  io::Frame frame{.step = solver_.steps(),
                  .time = solver_.time(),
                  .columns = solver_.columns(),
                  .state = std::move(state)};
  if (const std::string bad = flow::not_finite(frame.columns, solver_.particle()); !bad.empty())
    throw flow::Diverged(bad);
  on_the_way([&] {
    tables_.rows(RunTables::of_frames, solver_.frame_rows());
    tables_.keep(frame);
    frame.state[fields_key] = fields_;
    io::append_frame(folder_, frame);
  });
}

void RunFiles::field(const io::Field& field) {
  if (!fields_.empty() && !fs::exists(folder_ / "fields.h5"))
    throw std::runtime_error(fmt::format("{} was removed by someone else during the run",
                                         (folder_ / "fields.h5").string()));
  on_the_way([&] { io::append_field(folder_, field); });
  fields_.push_back(field.time);
}

}  // namespace vortree::app
