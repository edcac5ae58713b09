#include "app/loop/run.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "app/folder/older_run.hpp"
#include "app/folder/output_folder.hpp"
#include "app/folder/run_files.hpp"
#include "app/install_paths.hpp"
#include "app/loop/probes.hpp"
#include "app/loop/progress.hpp"
#include "app/loop/rows.hpp"
#include "app/loop/sample.hpp"
#include "app/loop/signals.hpp"
#include "app/loop/summary.hpp"
#include "app/loop/threads.hpp"
#include "app/loop/timetable.hpp"
#include "app/plot.hpp"
#include "app/say.hpp"
#include "base/clock.hpp"
#include "base/free_memory.hpp"
#include "checks/checks.hpp"
#include "flow/courses.hpp"
#include "flow/paths/carried_tracers.hpp"
#include "io/files.hpp"
#include "io/frames/frames.hpp"
#include "io/quote.hpp"
#include "provenance/provenance.hpp"

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
        figures_as_(options.figures_as),
        timetable_(scene_),
        scales_(flow::scales_of(scene_)),
        solver_(scene_.computed_by().begin(scene_, machine_memory())),
        rows_(*solver_, scales_),
        tracers_(scene_.tracers, scene_.tracers.empty() ? body::Bodies{} : flow::bodies_of(scene_)),
        probes_(scene_),
        files_(scene_, *solver_, {rows_.names(), probes_.names()}, folder_) {}

  void begin();
  void resume();
  RunResult go();

 private:
  double time(long step) const { return timetable_.time(step); }
  long step() const { return solver_->steps(); }

  bool reach_end();
  void advance();
  void save();
  void save_fields();
  void observe();
  [[noreturn]] void give_up(long failed, const std::string& reason);
  std::string kept() const;
  Totals totals_so_far() const;
  RunResult finish();
  Rows::Write writer() {
    return [this](const std::vector<double>& row) { files_.row(row); };
  }

  Stopwatch watch_;
  double processor_start_ = processor_seconds();
  std::vector<std::string> origin_ = provenance();
  io::Scene scene_;
  fs::path folder_;
  bool figures_;
  std::vector<std::string> figures_as_;
  Timetable timetable_;
  flow::Scales scales_;
  std::unique_ptr<flow::Solver> solver_;
  Rows rows_;
  flow::CarriedTracers tracers_;
  Probes probes_;
  RunFiles files_;
  Totals totals_;
  Stopwatch::Phases before_step_;
  long saved_step_ = -1;
};

void Run::begin() {
  files_.begin();
  tracers_.release(-1, 0);
  observe();
  files_.probed(probes_.rows(*solver_));
  save_fields();
  save();
}

void Run::resume() {
  const io::Frame frame = files_.last_frame();
  const std::string file = (folder_ / "frames.h5").string();
  if (frame.step > timetable_.last_step())
    throw io::InputError(
        fmt::format("{}: the last frame is that of t = {:.9g}, beyond time.end = {:.9g}", file,
                    time(frame.step), scene_.time.end));
  try {
    flow::hold_courses(scene_, frame.state);
    solver_->restore(frame.step, frame.columns, frame.state);
    rows_.restore(frame.state);
    tracers_.restore(frame.state);
    totals_.restore(frame.state);
    files_.resume(frame);
  } catch (const Refused& other) {
    throw io::InputError(fmt::format("{}: {}", file, other.what()));
  } catch (const std::out_of_range& missing) {
    throw io::InputError(
        fmt::format("{}: {}; another version of the program has written it", file, missing.what()));
  }
  saved_step_ = step();
  say("going on from step {}, t = {:g}", step(), time(step()));
}

/// After a step, and at the start.
void Run::observe() {
  const auto particles = static_cast<double>(solver_->particles());
  totals_.particle_steps += step() > 0 ? particles : 0;
  totals_.most_particles = std::max(totals_.most_particles, particles);
  watch_.end();
  std::vector<double> seconds{totals_.seconds + watch_.elapsed()};
  for (const std::string& phase : rows_.phases()) {
    double before = 0;
    for (const auto& [name, lap] : before_step_)
      if (name == phase) before = lap;
    seconds.push_back(watch_.seconds(phase) - before);
  }
  before_step_ = watch_.phases();
  rows_.add(seconds, writer());
}

/// Saves the state before the step that failed, and says so.
void Run::give_up(long failed, const std::string& reason) {
  save();
  throw std::runtime_error(
      fmt::format("step {}, t = {:g}: {}; {}", failed, time(failed), reason, kept()));
}

std::string Run::kept() const {
  if (saved_step_ < 0) return "there is no good frame";
  return fmt::format("the last good frame is that of step {} in {}", saved_step_,
                     (folder_ / "frames.h5").string());
}

Totals Run::totals_so_far() const {
  Totals now = totals_;
  now.seconds += watch_.elapsed();
  now.processor_seconds += processor_seconds() - processor_start_;
  return now;
}

void Run::advance() {
  tracers_.sample(*solver_);
  try {
    solver_->step([this](std::string_view phase) { watch_.begin(phase); });
  } catch (const flow::Diverged& reason) {
    give_up(step() + 1, reason.what());
  }
  tracers_.carry(scene_.time.dt);
  tracers_.release(time(step() - 1), time(step()));
  observe();
  watch_.begin("output");
  files_.probed(probes_.rows(*solver_));
  save_fields();  // before the frame, which tells of it
  if (timetable_.frame_due(step())) save();
  watch_.end();
}

void Run::save() {
  if (saved_step_ == step()) return;
  flow::State state;
  solver_->save(state);
  rows_.save(state);
  tracers_.save(state);
  flow::save_courses(scene_, solver_->time(), state);
  totals_so_far().save(state);
  try {
    files_.frame(std::move(state));
  } catch (const flow::Diverged& bad) {
    throw std::runtime_error(
        fmt::format("step {}, t = {:g}: {}; {}", step(), time(step()), bad.what(), kept()));
  }
  saved_step_ = step();
}

void Run::save_fields() {
  if (timetable_.field_due(step())) files_.field(picture(*solver_, scene_.output));
}

RunResult Run::go() {
  return reach_end() ? finish() : RunResult{};
}

/// False if it was told to stop before.
bool Run::reach_end() {
  const double start = time(step());
  StopRequest stop;
  ProgressLine progress;
  ThreadsOfRun threads;
  while (step() < timetable_.last_step()) {
    advance();
    threads.after_step();
    progress.show({.step = step(),
                   .time = time(step()),
                   .dt = scene_.time.dt,
                   .start = start,
                   .end = time(timetable_.last_step()),
                   .particles = solver_->particles(),
                   .particle = solver_->particle(),
                   .drift = solver_->drift()});
    if (stop && step() < timetable_.last_step()) {
      progress.clear();
      save();
      say("stopped at step {}, t = {:g}; the same command with --resume goes on", step(),
          time(step()));
      return false;
    }
  }
  progress.clear();
  return true;
}

RunResult Run::finish() {
  rows_.finish(writer());
  files_.end();
  const std::vector<checks::Verdict> list = checks::verdicts(scene_, folder_, *solver_, scales_);
  totals_ = totals_so_far();
  io::write_text(folder_ / "summary.json",
                 summary(scene_, folder_, *solver_, rows_.phases(), totals_, origin_, list));
  if (figures_) plot(folder_, {}, figures_as_);
  tell("{} steps, {} {}s at the end, {:.1f} s, {:.2f} million particle-steps/s; results in {}\n",
       step(), solver_->particles(), solver_->particle(), totals_.seconds,
       totals_.particle_steps / totals_.seconds / 1e6, io::printable(folder_.string()));
  if (const std::string words = solver_->closing().words; !words.empty()) tell("{}\n", words);
  tell("{}\n", checks::verdict_line(list));
  return {.finished = true,
          .verdicts = list,
          .steps = step(),
          .most_particles = totals_.most_particles,
          .particle_steps = totals_.particle_steps,
          .seconds = totals_.seconds,
          .processor_seconds = totals_.processor_seconds,
          .threads = omp_get_max_threads(),
          .origin = origin_};
}

/// One that was killed before its first frame was on the disk can only begin anew.
void require_run(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder / "frames.h5", error))
    throw io::InputError(
        fmt::format("{} holds no run to go on with; without --resume it begins", folder.string()));
}

/// A run that is resumed keeps the step that was chosen for it, whatever its end is by now.
io::Scene scene_of(const RunOptions& options, const flow::Methods& among) {
  const fs::path file = find_scene(options.scene);
  io::Scene scene = io::load_scene(file, among, options.overrides);
  if (!options.resume || !scene.origin.step_chosen) return scene;
  const io::Scene was = scene_of_frames(options.out / "frames.h5", scene);
  std::vector<std::string> overrides = options.overrides;
  overrides.push_back(fmt::format("time.dt={}", was.time.dt));
  return io::load_scene(file, among, overrides);
}

}  // namespace

bool RunResult::passed() const {
  return finished && std::ranges::none_of(verdicts, &checks::Verdict::missed);
}

RunResult run(const RunOptions& options, const flow::Methods& among) {
  if (options.resume) require_run(options.out);
  io::Scene scene = scene_of(options, among);
  const std::vector<std::string> doubts = warnings(scene);
  const OutputFolder folder(options.out);
  if (!options.resume && !options.overwrite) {
    refuse_older_run(options.out);
    if (options.figures) refuse_older_figures(options.out, {}, options.figures_as);
  }
  for (const std::string& doubt : doubts) say("warning: {}", doubt);
  Run run(std::move(scene), options);
  options.resume ? run.resume() : run.begin();
  return run.go();
}

}  // namespace vortree::app
