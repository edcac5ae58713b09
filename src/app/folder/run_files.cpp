#include "app/folder/run_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "app/install_paths.hpp"
#include "app/say.hpp"
#include "io/files.hpp"
#include "io/while_reading.hpp"
#include "vortex/blobs/energy.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_for_energy = 20000;
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

/// The first difference that would change the flow itself, or nothing.
std::string difference(const io::Scene& a, const io::Scene& b) {
  if (a.flow != b.flow) return "[flow]";
  if (a.body != b.body) return "[body]";
  if (a.plunge != b.plunge) return "[plunge]";
  if (a.diffusion != b.diffusion) return "[diffusion]";
  if (a.cores != b.cores) return "[cores]";
  if (a.splitting != b.splitting) return "[splitting]";
  if (a.merging != b.merging) return "[merging]";
  if (a.initial != b.initial) return "[initial]";
  if (a.time.dt != b.time.dt || a.time.scheme != b.time.scheme) return "[time]";
  if (a.velocity != b.velocity) return "[velocity]";
  return a.seed != b.seed ? "seed" : "";
}

io::Scene stored_scene(const io::RunInfo& info, const fs::path& file, const fs::path& scene) {
  try {
    return io::parse_scene(info.resolved, scene);
  } catch (const io::InputError& error) {
    throw io::InputError(
        fmt::format("{}: the scene stored in it is none: {}", file.string(), error.what()));
  }
}

}  // namespace

RunFiles::RunFiles(const io::Scene& scene, const flow::FlowCase& flow, fs::path folder)
    : scene_(scene),
      flow_(flow),
      folder_(std::move(folder)),
      tables_(folder_, flow.wall != nullptr) {}

void RunFiles::require_outputs() const {
  std::vector<fs::path> inputs{scene_.origin.path};
  for (const auto& reference : {scene_.check.drag_reference, scene_.check.wall_vorticity_reference,
                                scene_.check.moments_reference})
    if (reference) inputs.push_back(io::reference_path(scene_, *reference));
  for (const char* name : {"frames.h5", "frames.xdmf", "fields.h5", "fields.xdmf", "summary.json"})
    io::require_replaceable(folder_ / name, inputs);
  for (const std::string& name : tables_.names()) io::require_replaceable(folder_ / name, inputs);
  io::require_writable(folder_ / "frames.h5", inputs);
}

void RunFiles::begin() {
  require_outputs();
  io::remove_file(folder_ / "summary.json");
  io::create_frames(folder_, run_info(scene_));
  io::remove_file(folder_ / "fields.h5");
  io::remove_file(folder_ / "fields.xdmf");
  tables_.begin();
}

io::Frame RunFiles::last_frame() const {
  const fs::path file = folder_ / "frames.h5";
  const io::WhileReading reading(file);
  io::RecoveredFrames found = io::read_last_good(file);
  if (!found.warning.empty()) say_line(found.warning);
  if (!found.last) throw io::InputError(fmt::format("{}: no frame to go on from", file.string()));
  const io::Scene was = stored_scene(found.info, file, scene_.origin.path);
  if (const std::string where = difference(was, scene_); !where.empty())
    throw io::InputError(
        fmt::format("{}: was run with another {} than {} has now; only time.end, "
                    "[output] and [check] may change on the way",
                    file.string(), where, scene_.origin.path.string()));
  return *std::move(found.last);
}

/// One row of report.csv a step, of which the last still waits in the history; of the other table
/// as many as a frame adds.
std::vector<double> RunFiles::expected_times(RunTables::Kind kind, long step) const {
  std::vector<double> times;
  if (kind == RunTables::report) {
    for (long s = 1; s < step; ++s) times.push_back(static_cast<double>(s) * scene_.time.dt);
    return times;
  }
  io::visit_frames(folder_ / "frames.h5", step, [&](const io::Frame& frame) {
    std::size_t rows = frame.x.size() > most_for_energy ? 0 : 1;
    if (flow_.wall) rows = frame.step > 0 ? flow_.wall->panels() : 0;
    times.insert(times.end(), rows, frame.time);
  });
  return times;
}

void RunFiles::resume_fields(const io::Frame& frame) {
  const std::vector<double> kept = io::rewind_fields(folder_, frame.time);
  const auto were = frame.state.find(fields_key);
  fields_ = were == frame.state.end() ? kept : were->second;
  std::vector<double> lost;
  std::ranges::copy_if(fields_, std::back_inserter(lost),
                       [&](double t) { return std::ranges::find(kept, t) == kept.end(); });
  if (!lost.empty())
    say("{}: the pictures of t = {} are lost, and are not made again",
        (folder_ / "fields.h5").string(), fmt::join(lost, ", "));
}

void RunFiles::resume(const io::Frame& frame) {
  require_outputs();
  tables_.resume(frame, [&](RunTables::Kind kind) { return expected_times(kind, frame.step); });
  resume_fields(frame);
  io::rewind_frames(folder_, frame.step);
}

void RunFiles::row(const flow::Record& record) {
  const auto all = record.values();
  tables_.row(RunTables::report, std::span(all).first(flow::Record::columns));
}

void RunFiles::frame(io::Frame frame) {
  on_the_way([&] {
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

void RunFiles::wall(double time, std::span<const double> sheet, std::span<const double> vorticity) {
  const double T = 2 * flow_.speed * time / flow_.diameter;
  const Vec2 s = flow_.along;
  for (std::size_t i = 0; i < flow_.wall->panels(); ++i) {
    const Vec2 d = flow_.wall->middle(i);
    const double angle = std::atan2(s.x * d.y - s.y * d.x, dot(s, d)) * 180 / std::numbers::pi;
    tables_.row(RunTables::other, std::array{time, T, angle, vorticity[i], sheet[i]});
  }
}

void RunFiles::energy(double time, const vortex::Blobs& blobs) {
  if (blobs.size() > most_for_energy) return;
  const vortex::Energy now = vortex::energy(blobs);
  tables_.row(RunTables::other, std::array{time, now.energy, now.enstrophy});
}

}  // namespace vortree::app
