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

/// The scene of a run that the list has, if it is not to the letter what the run began with.
/// throws  io::InputError if it would be another flow
std::optional<io::Scene> changed_scene(const KeptPlan& kept, const Member& m, const fs::path& run) {
  const fs::path file = run / "frames.h5";
  const io::RunInfo info = io::info_of_frames(file);
  if (info.scene == kept.text && info.overrides == all_overrides(kept.plan, m)) return std::nullopt;
  io::Scene now = scene_of(kept, m);
  const io::Scene was = scene_of_frames(file, now);
  if (now.origin.step_chosen) now.time.dt = was.time.dt;
  const std::string where = io::flow_difference(was, now);
  if (where.empty()) return now;
  throw io::InputError(
      fmt::format("{}: is a run of another {} than its sweep has: it does not belong to the others",
                  run.string(), where));
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
  const auto scene = changed_scene(kept, m, run);
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
  io::require_writable(folder / "sweep.csv", std::array{kept.file});
  write_csv(folder / "sweep.csv", kept.scene, kept.plan, members);
  return report(folder, kept.plan, members, formats);
}

}  // namespace vortree::app
