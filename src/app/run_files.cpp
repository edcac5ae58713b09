#include "app/run_files.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "app/places.hpp"
#include "vortex/energy.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> wall_columns{"t", "T", "angle_deg", "vorticity", "sheet"};
const std::vector<std::string> energy_columns{"t", "energy", "enstrophy"};
constexpr std::size_t most_for_energy = 20000;

io::RunInfo run_info(const io::Scene& scene) {
  return {.version = version(),
          .scene_path = scene.origin.path.string(),
          .scene = scene.origin.text,
          .resolved = io::resolved(scene),
          .overrides = scene.origin.overrides,
          .seed = scene.seed,
          .units = "consistent: lengths, times and circulations as in the scene"};
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

}  // namespace

RunFiles::RunFiles(const io::Scene& scene, const FlowCase& flow, fs::path folder)
    : scene_(scene), flow_(flow), folder_(std::move(folder)) {}

void RunFiles::begin() {
  io::create_frames(folder_, run_info(scene_));
  fs::remove(folder_ / "fields.h5");
  fs::remove(folder_ / "summary.json");
  report_.emplace(folder_ / "report.csv", Record::names());
  if (flow_.wall)
    wall_.emplace(folder_ / "wall.csv", wall_columns);
  else
    energy_.emplace(folder_ / "energy.csv", energy_columns);
}

io::Frame RunFiles::last_frame() const {
  const fs::path file = folder_ / "frames.h5";
  io::RecoveredFrames found = io::read_last_good(file);
  if (!found.warning.empty()) fmt::print(stderr, "vortree: {}\n", found.warning);
  if (!found.last) throw io::InputError(fmt::format("{}: no frame to go on from", file.string()));
  const io::Scene was = io::parse_scene(found.info.resolved, scene_.origin.path);
  if (const std::string where = difference(was, scene_); !where.empty())
    throw io::InputError(
        fmt::format("{}: was run with another {} than {} has now; only time.end, "
                    "[output] and [check] may change on the way",
                    file.string(), where, scene_.origin.path.string()));
  return *std::move(found.last);
}

void RunFiles::resume(long step) {
  const auto time = [&](long s) { return static_cast<double>(s) * scene_.time.dt; };
  io::rewind_frames(folder_, step);
  io::rewind_fields(folder_, time(step));
  // The row of the frame itself waits in the history for the step after it.
  report_ = io::Report::resume(folder_ / "report.csv", Record::names(), time(step - 1));
  if (flow_.wall)
    wall_ = io::Report::resume(folder_ / "wall.csv", wall_columns, time(step));
  else
    energy_ = io::Report::resume(folder_ / "energy.csv", energy_columns, time(step));
}

void RunFiles::row(const Record& record) {
  const auto all = record.values();
  report_->row(std::span(all).first(Record::columns));
}

void RunFiles::frame(const io::Frame& frame) {
  io::append_frame(folder_, frame);
}

void RunFiles::field(const io::Field& field) {
  io::append_field(folder_, field);
}

void RunFiles::wall(double time, std::span<const double> sheet, std::span<const double> vorticity) {
  const double T = 2 * flow_.speed * time / flow_.diameter;
  const vortex::Vec2 s = flow_.along;
  for (std::size_t i = 0; i < flow_.wall->panels(); ++i) {
    const vortex::Vec2 d = flow_.wall->middle(i);
    const double angle = std::atan2(s.x * d.y - s.y * d.x, dot(s, d)) * 180 / std::numbers::pi;
    wall_->row(std::array{time, T, angle, vorticity[i], sheet[i]});
  }
}

void RunFiles::energy(double time, const vortex::Blobs& blobs) {
  if (blobs.size() > most_for_energy) return;
  const vortex::Energy now = vortex::energy(blobs);
  energy_->row(std::array{time, now.energy, now.enstrophy});
}

}  // namespace vortree::app
