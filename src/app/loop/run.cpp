#include "app/loop/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/folder/older_run.hpp"
#include "app/folder/output_folder.hpp"
#include "app/folder/run_files.hpp"
#include "app/install_paths.hpp"
#include "app/loop/progress.hpp"
#include "app/loop/signals.hpp"
#include "app/loop/summary.hpp"
#include "app/plot.hpp"
#include "app/say.hpp"
#include "base/clock.hpp"
#include "base/free_memory.hpp"
#include "checks/checks.hpp"
#include "checks/cost.hpp"
#include "checks/warnings.hpp"
#include "flow/flow_case.hpp"
#include "flow/health.hpp"
#include "flow/record.hpp"
#include "flow/sample.hpp"
#include "flow/timetable.hpp"
#include "io/frames/frames.hpp"
#include "io/json.hpp"
#include "io/quote.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

/// One run on its way. Everything that the next step depends on goes into a frame.
class Run {
 public:
  Run(io::Scene scene, const RunOptions& options)
      : scene_(std::move(scene)),
        folder_(options.out),
        figures_(options.figures),
        timetable_(scene_),
        flow_(flow::flow_case(scene_)),
        files_(scene_, flow_, folder_),
        history_(flow_),
        growth_(flow_) {
    flow_.held_blobs = checks::blobs_in(machine_memory());
  }

  void begin();
  void resume();
  RunResult go();

 private:
  double time(long step) const { return timetable_.time(step); }

  void advance();
  void save();
  void save_fields();
  void observe(const vortex::Wake& wake);
  [[noreturn]] void give_up(const std::string& reason, vortex::Blobs last_good);
  std::string kept() const;
  double drift(const flow::Record& record) const;
  double share_gone() const;
  RunResult finish();
  flow::History::Write writer() {
    return [this](const flow::Record& record) { files_.row(record); };
  }

  io::Scene scene_;
  fs::path folder_;
  bool figures_;
  flow::Timetable timetable_;
  flow::FlowCase flow_;
  RunFiles files_;
  vortex::Blobs blobs_;
  flow::History history_;
  Totals totals_;
  flow::Growth growth_;
  Stopwatch watch_;
  Stopwatch::Phases before_step_;
  std::vector<double> sheet_, wall_vorticity_;
  double second_moment_at_start_ = 0;
  long step_ = 0, saved_step_ = -1;
};

void Run::begin() {
  files_.begin();
  blobs_ = flow::initial_blobs(scene_);
  const vortex::Wake wake = vortex::start(blobs_, flow_.problem);
  observe(wake);
  save_fields();
  save();
}

void Run::resume() {
  const io::Frame frame = files_.last_frame();
  if (frame.step > timetable_.last_step())
    throw io::InputError(
        fmt::format("{}: the last frame is that of t = {:.9g}, beyond time.end = {:.9g}",
                    (folder_ / "frames.h5").string(), time(frame.step), scene_.time.end));
  step_ = saved_step_ = frame.step;
  flow_.problem.time = time(step_);
  blobs_ = {frame.x, frame.y, frame.gamma, frame.sigma};
  if (const auto x = frame.state.find("x_in_flow"); x != frame.state.end()) {
    blobs_.x = x->second;
    blobs_.y = frame.state.at("y_in_flow");
  }
  for (const auto& [name, column] :
       {std::pair{"covariance_xx", &blobs_.xx}, std::pair{"covariance_xy", &blobs_.xy}})
    if (const auto kept = frame.state.find(name); kept != frame.state.end()) *column = kept->second;
  history_.restore(frame.state.at("history"));
  const std::vector<double>& t = frame.state.at("totals");
  totals_ = {t.at(0), t.at(1), t.at(2), t.at(3)};
  second_moment_at_start_ = t.at(4);
  if (const auto gone = frame.state.find("retired"); gone != frame.state.end())
    flow_.problem.retired = {gone->second.at(0),
                             {gone->second.at(1), gone->second.at(2)},
                             gone->second.size() > 3 ? gone->second[3] : 0};
  growth_.add(blobs_.size());
  files_.resume(frame);
  say("going on from step {}, t = {:g}", step_, time(step_));
}

void Run::observe(const vortex::Wake& wake) {
  if (flow_.wall) {
    sheet_ = wake.sheet;
    wall_vorticity_ = wake.wall_vorticity;
  }
  growth_.add(blobs_.size());
  flow::Record record = flow::measure(step_, blobs_, wake, flow_);
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
      fmt::format("step {}, t = {:g}: {}; {}", failed, time(failed), reason, kept()));
}

std::string Run::kept() const {
  if (saved_step_ < 0) return "there is no good frame";
  return fmt::format("the last good frame is that of step {} in {}", saved_step_,
                     (folder_ / "frames.h5").string());
}

void Run::advance() {
  ++step_;
  vortex::Blobs before = blobs_;
  vortex::Wake wake;
  flow_.step_to(time(step_));
  flow_.problem.most_blobs = growth_.most(time(step_));
  try {
    wake = vortex::step(blobs_, flow_.problem, static_cast<std::uint64_t>(step_),
                        [this](std::string_view phase) { watch_.begin(phase); });
  } catch (const vortex::Multiplied& many) {
    const std::string reason = flow::multiplied(many.blobs, before.size(), flow_);
    give_up(reason, std::move(before));
  } catch (const std::exception& refused) {
    give_up(refused.what(), std::move(before));
  }
  watch_.begin("output");
  if (const std::string reason = flow::broken(blobs_, flow_, time(step_)); !reason.empty())
    give_up(reason, std::move(before));
  flow_.problem.retired = wake.retired;
  flow_.problem.time = time(step_);
  observe(wake);
  watch_.begin("output");
  save_fields();  // before the frame, which tells of it
  if (timetable_.frame_due(step_)) save();
  watch_.end();
}

void Run::save() {
  if (saved_step_ == step_) return;
  const vortex::Velocities u = vortex::velocity_at({blobs_.x, blobs_.y}, blobs_, flow_.problem);
  const Vec2 origin = flow_.origin.at(time(step_)), drift = flow_.origin.drift;
  io::Frame frame{.step = step_,
                  .time = time(step_),
                  .x = flow::moved(blobs_.x, origin.x),
                  .y = flow::moved(blobs_.y, origin.y),
                  .gamma = blobs_.gamma,
                  .sigma = blobs_.sigma,
                  .u = flow::moved(u.u, drift.x),
                  .v = flow::moved(u.v, drift.y),
                  .state = {}};
  if (dot(origin, origin) > 0) {
    frame.state["x_in_flow"] = blobs_.x;
    frame.state["y_in_flow"] = blobs_.y;
  }
  frame.state["covariance_xx"] = blobs_.xx;
  frame.state["covariance_xy"] = blobs_.xy;
  frame.state["history"] = history_.saved();
  frame.state["totals"] = {totals_.particle_steps, totals_.most_blobs,
                           totals_.seconds + watch_.elapsed(), totals_.largest_drift,
                           second_moment_at_start_};
  const vortex::Retired& gone = flow_.problem.retired;
  frame.state["retired"] = {gone.gamma, gone.moment.x, gone.moment.y, gone.of_both_signs};
  if (flow_.wall) {
    frame.state["sheet"] = sheet_;
    frame.state["wall_vorticity"] = wall_vorticity_;
    if (step_ > 0)  // the wall vorticity of an impulsive start is infinite
      files_.wall(time(step_), sheet_, wall_vorticity_);
  } else {
    files_.energy(time(step_), blobs_);
  }
  if (const std::string bad = flow::not_finite(frame); !bad.empty())
    throw std::runtime_error(
        fmt::format("step {}, t = {:g}: {}; {}", step_, time(step_), bad, kept()));
  files_.frame(std::move(frame));
  saved_step_ = step_;
}

void Run::save_fields() {
  if (timetable_.field_due(step_))
    files_.field(flow::picture(time(step_), scene_.output, blobs_, flow_));
}

/// Relative drift of what is kept: circulation beside a wall, else the second moment but for
/// diffusion.
double Run::drift(const flow::Record& now) const {
  if (flow_.wall) return std::abs(now.circulation) / (flow_.speed * flow_.diameter);
  const double grown = 4 * flow_.problem.flow.nu * now.t * now.circulation;
  const double expected = second_moment_at_start_ + grown;
  return expected == 0 ? 0 : std::abs(now.second_moment / expected - 1);
}

/// Of all vorticity of both signs, what has left the box.
double Run::share_gone() const {
  double here = 0;
  for (double gamma : blobs_.gamma) here += std::abs(gamma);
  const double gone = flow_.problem.retired.of_both_signs;
  return gone > 0 ? gone / (gone + here) : 0;
}

RunResult Run::go() {
  const double start = time(step_);
  StopRequest stop;
  ProgressLine progress;
  while (step_ < timetable_.last_step()) {
    advance();
    progress.show({.step = step_,
                   .time = time(step_),
                   .dt = scene_.time.dt,
                   .start = start,
                   .end = time(timetable_.last_step()),
                   .particles = blobs_.size(),
                   .drift = totals_.largest_drift});
    if (stop && step_ < timetable_.last_step()) {
      progress.clear();
      save();
      say("stopped at step {}, t = {:g}; the same command with --resume goes on", step_,
          time(step_));
      return {};
    }
  }
  progress.clear();
  return finish();
}

RunResult Run::finish() {
  history_.finish(writer());
  files_.end();
  const std::vector<checks::Verdict> list = checks::verdicts(scene_, folder_, blobs_, flow_);
  totals_.seconds += watch_.elapsed();
  io::Json json = summary(scene_, folder_, step_, blobs_.size(), totals_, list);
  if (flow_.box) {
    json["left_box"]["circulation"] = flow_.problem.retired.gamma;
    json["left_box"]["of_both_signs"] = flow_.problem.retired.of_both_signs;
    json["left_box"]["share"] = share_gone();
  }
  io::write_json(folder_ / "summary.json", json);
  if (figures_) plot(folder_);
  tell("{} steps, {} blobs at the end, {:.1f} s, {:.2f} million particle-steps/s; results in {}\n",
       step_, blobs_.size(), totals_.seconds, totals_.particle_steps / totals_.seconds / 1e6,
       io::printable(folder_.string()));
  if (flow_.box)
    tell("{:.0f} % of the vorticity of both signs has left merging.box, {:.3g} net\n",
         100 * share_gone(), flow_.problem.retired.gamma);
  tell("{}\n", checks::verdict_line(list));
  return {.finished = true,
          .verdicts = list,
          .steps = step_,
          .most_blobs = totals_.most_blobs,
          .particle_steps = totals_.particle_steps,
          .seconds = totals_.seconds};
}

/// A run that is resumed keeps the step that was chosen for it, whatever its end is by now.
io::Scene scene_of(const RunOptions& options) {
  const fs::path file = find_scene(options.scene);
  io::Scene scene = io::load_scene(file, options.overrides);
  if (!options.resume || !scene.origin.step_chosen) return scene;
  const std::string was = io::info_of_frames(options.out / "frames.h5").resolved;
  std::vector<std::string> overrides = options.overrides;
  overrides.push_back(fmt::format("time.dt={}", io::parse_scene(was, file).time.dt));
  return io::load_scene(file, overrides);
}

}  // namespace

bool RunResult::passed() const {
  return finished && std::ranges::none_of(verdicts, &checks::Verdict::missed);
}

RunResult run(const RunOptions& options) {
  io::Scene scene = scene_of(options);
  checks::refuse_beyond(scene, machine_memory());
  const OutputFolder folder(options.out);
  if (!options.resume && !options.overwrite) refuse_older_run(options.out);
  for (const std::string& doubt : checks::warnings(scene)) say("warning: {}", doubt);
  Run run(std::move(scene), options);
  options.resume ? run.resume() : run.begin();
  return run.go();
}

}  // namespace vortree::app
