#include "app/run.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "app/advice.hpp"
#include "app/clock.hpp"
#include "app/flow_case.hpp"
#include "app/memory.hpp"
#include "app/outcome.hpp"
#include "app/picture.hpp"
#include "app/places.hpp"
#include "app/plot.hpp"
#include "app/progress.hpp"
#include "app/record.hpp"
#include "app/sanity.hpp"
#include "app/signals.hpp"
#include "io/frames.hpp"
#include "io/json.hpp"
#include "io/report.hpp"
#include "io/table.hpp"
#include "vortex/energy.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> wall_columns{"t", "T", "angle_deg", "vorticity", "sheet"};
const std::vector<std::string> energy_columns{"t", "energy", "enstrophy"};
constexpr std::size_t most_for_energy = 20000;  // blobs: its sum is over all pairs

/// Numbers of a whole run, over all its resumptions.
struct Totals {
  double particle_steps = 0, most_blobs = 0, seconds = 0, largest_drift = 0;
};

/// One run on its way. Everything that the next step depends on goes into a frame.
class Run {
 public:
  Run(io::Scene scene, const RunOptions& options)
      : scene_(std::move(scene)),
        folder_(options.out),
        figures_(options.figures),
        flow_(flow_case(scene_)),
        history_(flow_) {}

  void begin();
  void resume();
  RunResult go();

 private:
  long last_step() const { return std::lround(scene_.time.end / scene_.time.dt); }
  double time(long step) const { return static_cast<double>(step) * scene_.time.dt; }
  long steps_between_frames() const {
    return std::max(1L, std::lround(scene_.output.frames / scene_.time.dt));
  }

  void advance();
  void save();
  void save_wall();
  void save_fields();
  void observe(const vortex::Wake& wake);
  [[noreturn]] void give_up(const std::string& reason, vortex::Blobs last_good);
  double drift(const Record& record) const;
  RunResult finish();
  io::Json summary(std::span<const Verdict> verdicts) const;
  History::Write writer() {
    return [this](const Record& r) {
      const auto all = r.values();
      report_->row(std::span(all).first(Record::columns));
    };
  }

  io::Scene scene_;
  fs::path folder_;
  bool figures_;
  FlowCase flow_;
  vortex::Blobs blobs_;
  History history_;
  Totals totals_;
  Stopwatch watch_;
  Stopwatch::Phases before_step_;
  std::optional<io::Report> report_, wall_report_, energy_report_;
  std::vector<double> sheet_, wall_vorticity_;
  double second_moment_at_start_ = 0;
  long step_ = 0, saved_step_ = -1;
};

io::RunInfo run_info(const io::Scene& scene) {
  return {.version = version(),
          .scene_path = scene.origin.path.string(),
          .scene = scene.origin.text,
          .resolved = io::resolved(scene),
          .overrides = scene.origin.overrides,
          .seed = scene.seed,
          .units = "consistent: lengths, times and circulations as in the scene"};
}

void Run::begin() {
  io::create_frames(folder_, run_info(scene_));
  fs::remove(folder_ / "fields.h5");
  fs::remove(folder_ / "summary.json");
  report_.emplace(folder_ / "report.csv", Record::names());
  if (flow_.wall)
    wall_report_.emplace(folder_ / "wall.csv", wall_columns);
  else
    energy_report_.emplace(folder_ / "energy.csv", energy_columns);
  blobs_ = initial_blobs(scene_);
  const vortex::Wake wake = vortex::start(blobs_, flow_.problem);
  observe(wake);
  save();
  save_fields();
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

void Run::resume() {
  const fs::path file = folder_ / "frames.h5";
  const io::RecoveredFrames found = io::read_last_good(file);
  if (!found.warning.empty()) fmt::print(stderr, "vortree: {}\n", found.warning);
  if (!found.last) throw io::InputError(fmt::format("{}: no frame to go on from", file.string()));
  const io::Scene was = io::parse_scene(found.info.resolved, scene_.origin.path);
  if (const std::string where = difference(was, scene_); !where.empty())
    throw io::InputError(
        fmt::format("{}: was run with another {} than {} has now; only time.end, "
                    "[output] and [check] may change on the way",
                    file.string(), where, scene_.origin.path.string()));
  const io::Frame& frame = *found.last;
  step_ = saved_step_ = frame.step;
  flow_.problem.time = time(step_);
  blobs_ = {frame.x, frame.y, frame.gamma, frame.sigma};
  blobs_.xx = frame.state.at("covariance_xx");
  blobs_.xy = frame.state.at("covariance_xy");
  history_.restore(frame.state.at("history"));
  const std::vector<double>& t = frame.state.at("totals");
  totals_ = {t.at(0), t.at(1), t.at(2), t.at(3)};
  second_moment_at_start_ = t.at(4);
  if (const auto gone = frame.state.find("retired"); gone != frame.state.end())
    flow_.problem.retired = {gone->second.at(0), {gone->second.at(1), gone->second.at(2)}};
  io::rewind_frames(folder_, step_);
  io::rewind_fields(folder_, time(step_));
  // The row of the frame itself waits in the history for the step after it.
  report_ = io::Report::resume(folder_ / "report.csv", Record::names(), time(step_ - 1));
  if (flow_.wall)
    wall_report_ = io::Report::resume(folder_ / "wall.csv", wall_columns, time(step_));
  else
    energy_report_ = io::Report::resume(folder_ / "energy.csv", energy_columns, time(step_));
  fmt::print(stderr, "vortree: going on from step {}, t = {:g}\n", step_, time(step_));
}

void Run::observe(const vortex::Wake& wake) {
  if (flow_.wall) {
    sheet_ = wake.sheet;
    wall_vorticity_ = wake.wall_vorticity;
  }
  Record record = measure(step_, blobs_, wake, flow_);
  if (step_ == 0) second_moment_at_start_ = record.second_moment;
  totals_.particle_steps += step_ > 0 ? record.blobs : 0;
  totals_.most_blobs = std::max(totals_.most_blobs, record.blobs);
  totals_.largest_drift = std::max(totals_.largest_drift, drift(record));
  watch_.end();
  record.seconds = totals_.seconds + watch_.elapsed();
  const auto lap = [&](const char* phase) {
    double before = 0;
    for (const auto& [name, seconds] : before_step_)
      if (name == phase) before = seconds;
    return watch_.seconds(phase) - before;
  };
  record.seconds_convect = lap("convect");
  record.seconds_wall = lap("wall");
  record.seconds_split = lap("split");
  record.seconds_merge = lap("merge");
  record.seconds_output = lap("output");
  before_step_ = watch_.phases();
  history_.add(record, writer());
}

/// Saves the state before the step that broke, and says so.
void Run::give_up(const std::string& reason, vortex::Blobs last_good) {
  const long failed = step_;
  blobs_ = std::move(last_good);
  --step_;
  save();
  throw std::runtime_error(
      fmt::format("step {}, t = {:g}: {}; the last good frame is that of step {} in {}", failed,
                  time(failed), reason, saved_step_, (folder_ / "frames.h5").string()));
}

void Run::advance() {
  ++step_;
  vortex::Blobs before = blobs_;
  vortex::Wake wake;
  try {
    wake = vortex::step(blobs_, flow_.problem, static_cast<std::uint64_t>(step_),
                        [this](std::string_view phase) { watch_.begin(phase); });
  } catch (const std::exception& refused) {
    give_up(refused.what(), std::move(before));
  }
  watch_.begin("output");
  if (const std::string reason = broken(blobs_, before.size(), flow_, time(step_)); !reason.empty())
    give_up(reason, std::move(before));
  flow_.problem.retired = wake.retired;
  flow_.problem.time = time(step_);
  observe(wake);
  watch_.begin("output");
  if (step_ % steps_between_frames() == 0 || step_ == last_step()) save();
  save_fields();
  watch_.end();
}

void Run::save() {
  if (saved_step_ == step_) return;
  const vortex::Velocities u = vortex::velocity_at({blobs_.x, blobs_.y}, blobs_, flow_.problem);
  io::Frame frame{.step = step_,
                  .time = time(step_),
                  .x = blobs_.x,
                  .y = blobs_.y,
                  .gamma = blobs_.gamma,
                  .sigma = blobs_.sigma,
                  .u = u.u,
                  .v = u.v,
                  .state = {}};
  frame.state["covariance_xx"] = blobs_.xx;
  frame.state["covariance_xy"] = blobs_.xy;
  frame.state["history"] = history_.saved();
  frame.state["totals"] = {totals_.particle_steps, totals_.most_blobs,
                           totals_.seconds + watch_.elapsed(), totals_.largest_drift,
                           second_moment_at_start_};
  const vortex::Retired& gone = flow_.problem.retired;
  frame.state["retired"] = {gone.gamma, gone.moment.x, gone.moment.y};
  if (flow_.wall) {
    frame.state["sheet"] = sheet_;
    frame.state["wall_vorticity"] = wall_vorticity_;
    save_wall();
  } else if (blobs_.size() <= most_for_energy) {
    const vortex::Energy now = vortex::energy(blobs_);
    energy_report_->row(std::array{time(step_), now.energy, now.enstrophy});
  }
  io::append_frame(folder_, frame);
  saved_step_ = step_;
}

void Run::save_wall() {
  if (step_ == 0) return;  // the wall vorticity of an impulsive start is infinite
  const double t = time(step_), T = 2 * flow_.speed * t / flow_.diameter;
  const vortex::Vec2 s = flow_.along;
  for (std::size_t i = 0; i < flow_.wall->panels(); ++i) {
    const vortex::Vec2 c{scene_.body->centre[0], scene_.body->centre[1]};
    const vortex::Vec2 d = flow_.wall->middle(i) - c;
    const double angle = std::atan2(s.x * d.y - s.y * d.x, dot(s, d)) * 180 / std::numbers::pi;
    const std::array<double, 5> row{t, T, angle, wall_vorticity_[i], sheet_[i]};
    wall_report_->row(row);
  }
}

void Run::save_fields() {
  const bool due = std::ranges::any_of(
      scene_.output.fields, [&](double t) { return std::lround(t / scene_.time.dt) == step_; });
  if (due) io::append_field(folder_, picture(time(step_), scene_.output, blobs_, flow_));
}

/// Relative drift of what is kept: circulation beside a wall, else the second moment but for
/// diffusion.
double Run::drift(const Record& now) const {
  if (flow_.wall) return std::abs(now.circulation) / (flow_.speed * flow_.diameter);
  const double grown = 4 * flow_.problem.flow.nu * now.t * now.circulation;
  const double expected = second_moment_at_start_ + grown;
  return expected == 0 ? 0 : std::abs(now.second_moment / expected - 1);
}

RunResult Run::go() {
  const double start = time(step_);
  StopRequest stop;
  ProgressLine progress;
  while (step_ < last_step()) {
    advance();
    progress.show({.step = step_,
                   .time = time(step_),
                   .dt = scene_.time.dt,
                   .start = start,
                   .end = scene_.time.end,
                   .particles = blobs_.size(),
                   .drift = totals_.largest_drift});
    if (stop && step_ < last_step()) {
      progress.clear();
      save();
      fmt::print(stderr,
                 "vortree: stopped at step {}, t = {:g}; the same command with --resume goes on\n",
                 step_, time(step_));
      return {};
    }
  }
  progress.clear();
  return finish();
}

io::Json Run::summary(std::span<const Verdict> verdicts) const {
  io::Json json;
  json["scene"] = scene_.origin.path.string();
  json["title"] = scene_.title;
  json["version"] = version();
  json["threads"] = omp_get_max_threads();
  json["steps"] = std::int64_t{step_};
  json["blobs"] = static_cast<std::uint64_t>(blobs_.size());
  json["largest_blob_count"] = totals_.most_blobs;
  json["particle_steps"] = totals_.particle_steps;
  const double seconds = totals_.seconds + watch_.elapsed();
  json["particle_steps_per_second"] = totals_.particle_steps / seconds;
  json["peak_bytes"] = static_cast<std::uint64_t>(peak_bytes());
  json["largest_drift"] = totals_.largest_drift;
  json["seconds"]["total"] = seconds;
  const io::Table report(folder_ / "report.csv");
  for (const char* phase : {"convect", "wall", "split", "merge", "output"}) {
    const auto laps = report.column(std::string("seconds_") + phase);
    json["seconds"][phase] = std::accumulate(laps.begin(), laps.end(), 0.0);
  }
  json["check"]["passed"] = std::ranges::all_of(verdicts, &Verdict::passed);
  for (const Verdict& v : verdicts) {
    json["check"][v.what]["asked"] = v.asked;
    json["check"][v.what]["reached"] = v.reached;
    json["check"][v.what]["passed"] = v.passed();
  }
  return json;
}

RunResult Run::finish() {
  history_.finish(writer());
  const std::vector<Verdict> list = verdicts(scene_, folder_, blobs_, flow_);
  const io::Json json = summary(list);
  io::write_json(folder_ / "summary.json", json);
  const double seconds = totals_.seconds + watch_.elapsed();
  if (figures_) plot(folder_);
  fmt::print(
      "{} steps, {} blobs at the end, {:.1f} s, {:.2f} million particle-steps/s; results in {}\n",
      step_, blobs_.size(), seconds, totals_.particle_steps / seconds / 1e6, folder_.string());
  fmt::print("{}\n", verdict_line(list));
  return {.finished = true,
          .verdicts = list,
          .steps = step_,
          .most_blobs = totals_.most_blobs,
          .particle_steps = totals_.particle_steps,
          .seconds = seconds};
}

}  // namespace

bool RunResult::passed() const {
  return finished && std::ranges::all_of(verdicts, &Verdict::passed);
}

RunResult run(const RunOptions& options) {
  io::Scene scene = io::load_scene(find_scene(options.scene), options.overrides);
  for (const std::string& doubt : doubts(scene))
    fmt::print(stderr, "vortree: warning: {}\n", doubt);
  Run run(std::move(scene), options);
  options.resume ? run.resume() : run.begin();
  return run.go();
}

}  // namespace vortree::app
