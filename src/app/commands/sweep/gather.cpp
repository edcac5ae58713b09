#include "app/commands/sweep/gather.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "app/commands/sweep/plan_file.hpp"
#include "app/commands/sweep/report.hpp"
#include "app/commands/sweep/table.hpp"
#include "app/folder/output_folder.hpp"
#include "app/folder/run_files.hpp"
#include "app/loop/summary.hpp"
#include "app/loop/timetable.hpp"
#include "app/say.hpp"
#include "io/files.hpp"
#include "io/frames/read.hpp"
#include "io/frames/stored_scene.hpp"
#include "io/input_error.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

void lacks(Member& m, Lack lack, std::string why) {
  m.lack = lack;
  m.failure = std::move(why);
}

/// The scene that a run began with; none where files that it names are not on this machine.
std::optional<io::Scene> begun_with(const io::RunInfo& info, const fs::path& file,
                                    const fs::path& path) {
  try {
    return io::stored_scene(info, file, path, methods());
  } catch (const io::InputError&) {
    return std::nullopt;
  }
}

/// The scene of a run that the list has, in the steps that the run began with.
/// returns none if that is to the letter what it began with, and cannot be read here
/// throws  io::InputError if it would be another flow
std::optional<io::Scene> scene_asked(const KeptPlan& kept, const Member& m, const fs::path& run) {
  const fs::path file = run / "frames.h5";
  const io::RunInfo info = io::info_of_frames(file);
  if (info.scene == kept.text && info.overrides == all_overrides(kept.plan, m))
    return begun_with(info, file, kept.file);
  io::Scene now = scene_of(kept, m);
  const io::Scene was = scene_of_frames(file, now);
  if (now.origin.step_chosen) now.time.dt = was.time.dt;
  const std::string where = io::flow_difference(was, now);
  if (where.empty()) return now;
  throw io::InputError(
      fmt::format("{}: is a run of another {} than its sweep has: it does not belong to the others",
                  run.string(), where));
}

/// The time of a run's last frame; 0 if it cannot be told.
double last_time(const fs::path& run) {
  try {
    return io::label_of_frames(run / "frames.h5").last_time;
  } catch (const io::InputError&) {
    return 0;
  }
}

/// A run may have gone on to a later end than its list has now, whatever it began with.
/// throws  io::InputError if it has
void hold_end(const io::Scene& scene, const fs::path& run) {
  const double half_a_step = 0.5 * scene.time.dt;
  const double end = Timetable(scene).time(Timetable(scene).last_step()), last = last_time(run);
  if (last <= end + half_a_step) return;
  throw io::InputError(
      fmt::format("{}: the last frame is that of t = {:.9g}, which is beyond time.end = {:.9g} of "
                  "its sweep: it does not belong to the others",
                  run.string(), last, scene.time.end));
}

/// Where a run is that has not come to its end.
std::string place(const fs::path& run) {
  const std::string by = being_filled(run) ? ", being run" : "";
  try {
    const io::FramesLabel label = io::label_of_frames(run / "frames.h5");
    if (label.frames == 0) return "no frame yet" + by;
    return fmt::format("its last frame is that of t = {:g}{}", label.last_time, by);
  } catch (const io::InputError&) {
    return "its last frame cannot be read" + by;
  }
}

/// What a run says of its failure, if it has failed and nothing has been done about it since.
std::optional<std::string> failure_in(const fs::path& run) {
  std::error_code error;
  if (!fs::is_regular_file(run / "failed.txt", error)) return std::nullopt;
  const std::string words = io::read_text(run / "failed.txt");
  return words.substr(0, words.find('\n'));
}

void read(const KeptPlan& kept, const fs::path& run, Member& m) {
  std::error_code error;
  const auto failure = failure_in(run);
  if (!fs::exists(run / "frames.h5", error))
    return failure ? lacks(m, Lack::failed, *failure) : lacks(m, Lack::missing, "has not begun");
  const auto scene = scene_asked(kept, m, run);
  if (scene) hold_end(*scene, run);
  const auto result = result_in(run);
  if (result && (!scene || result->steps == Timetable(*scene).last_step())) {
    m.result = *result;
    return;
  }
  failure ? lacks(m, Lack::failed, *failure) : lacks(m, Lack::unfinished, place(run));
}

/// Runs beside those of the list are none of its, and are named.
void name_strangers(const fs::path& folder, const KeptPlan& kept, std::span<const Member> members) {
  std::set<fs::path> known;
  for (const Member& m : members) known.insert(folder_of(kept.plan, m));
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder))
    if (fs::exists(entry.path() / "frames.h5", error) && !known.contains(entry.path().filename()))
      say("warning: {} is no run of the list, and is left out", entry.path().string());
}

}  // namespace

int gather(const fs::path& folder, std::span<const std::string> formats) {
  const KeptPlan kept = kept_plan(folder);
  std::vector<Member> members = members_of(kept.plan);
  const OutputFolder shared(folder, OutputFolder::Use::shared);
  for (Member& m : members) read(kept, folder / folder_of(kept.plan, m), m);
  name_strangers(folder, kept, members);
  require_own_table(folder / "sweep.csv");
  io::require_writable(folder / "sweep.csv", std::array{kept.file});
  write_csv(folder / "sweep.csv", kept.scene, kept.plan, members);
  return report(folder, kept.plan, members, formats);
}

}  // namespace vortree::app
