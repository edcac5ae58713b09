#include "app/folder/run_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <stdexcept>

#include "app/folder/older_run.hpp"
#include "app/install_paths.hpp"
#include "app/say.hpp"
#include "io/files.hpp"
#include "io/scene/reference.hpp"
#include "io/scene/schema.hpp"
#include "io/tables/outline.hpp"
#include "io/while_reading.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

const std::string fields_key = "times of fields";  // in the state of a frame

io::RunInfo run_info(const io::Scene& scene) {
  return {.version = version(),
          .scene_path = scene.origin.path.string(),
          .scene = scene.origin.text,
          .resolved = io::resolved(scene),
          .overrides = scene.origin.overrides,
          .seed = scene.seed,
          .units = "consistent: lengths, times and circulations as in the scene"};
}

/// What can no longer be written in the middle of a run is nobody's input.
void on_the_way(const std::function<void()>& write) {
  try {
    write();
  } catch (const io::InputError& refused) {
    throw std::runtime_error(refused.what());
  }
}

/// What may change on the way: where a run ends, what it writes, and what it is held against. That
/// an accuracy was asked for does not count beside what was chosen by it.
bool may_change(std::string_view key) {
  return key == "title" || key == "accuracy" || key == "time.end" || key.starts_with("output.") ||
         key.starts_with("check.");
}

/// What scenes were like before they knew of a key: blobs were split into rings.
std::vector<std::string> before_its_keys(std::string_view resolved) {
  const std::size_t table = resolved.find("[splitting]\n");
  if (table == std::string_view::npos) return {};
  const std::string_view rest = resolved.substr(table);
  const bool known = rest.substr(0, rest.find("\n[")).find("\nscheme") != std::string_view::npos;
  return known ? std::vector<std::string>{} : std::vector<std::string>{"splitting.scheme=ring"};
}

io::Scene stored_scene(const io::RunInfo& info, const fs::path& file, const io::Scene& now) {
  try {
    return io::parse_scene(info.resolved, now.origin.path, now.methods,
                           before_its_keys(info.resolved));
  } catch (const io::InputError& error) {
    throw io::InputError(
        fmt::format("{}: the scene stored in it is none: {}", file.string(), error.what()));
  }
}

void require_time_of_step(const io::Frame& frame, double dt, const fs::path& file) {
  const double expected = static_cast<double>(frame.step) * dt;
  if (std::abs(frame.time - expected) <= 1e-12 * expected) return;
  throw io::InputError(fmt::format(
      "{}: the frame of step {} is that of t = {}, where steps of time.dt = {} come to t = {}: the "
      "file is damaged, or another run's",
      file.string(), frame.step, frame.time, dt, expected));
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
  io::create_frames(folder_, run_info(scene_), solver_.columns());
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
  const io::Scene was = stored_scene(found.info, file, scene_);
  if (const std::string where = flow_difference(was, scene_); !where.empty())
    throw io::InputError(
        fmt::format("{}: was run with another {} than {} has now, or than this version "
                    "chooses; only time.end, [output] and [check] may change on the way",
                    file.string(), where, scene_.origin.path.string()));
  require_time_of_step(*found.last, scene_.time.dt, file);
  return *std::move(found.last);
}

std::string flow_difference(const io::Scene& a, const io::Scene& b) {
  const std::string name = io::first_difference(a, b, may_change);
  const std::size_t dot = name.find('.');
  return dot == std::string::npos ? name : fmt::format("[{}]", name.substr(0, dot));
}

io::Scene scene_of_frames(const fs::path& frames, const io::Scene& now) {
  return stored_scene(io::info_of_frames(frames), frames, now);
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
