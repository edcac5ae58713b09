#include "app/commands/sweep/plan_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/install_paths.hpp"
#include "app/json.hpp"
#include "io/files.hpp"
#include "io/frames/stored_scene.hpp"
#include "io/input_error.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* name = "sweep.json";

KeptPlan plan_of(const RunOptions& options, const SweepPlan& plan) {
  const fs::path file = find_scene(options.scene);
  return {options.scene, fs::absolute(file).lexically_normal(), io::read_text(file), plan};
}

std::string page(const KeptPlan& kept) {
  Json json;
  json["scene"] = kept.scene;
  json["file"] = kept.file.string();
  json["fixed"] = kept.plan.fixed;
  for (const Axis& axis : kept.plan.axes)
    json["lists"].push_back(Json{{"key", axis.key}, {"values", axis.values}});
  json["text"] = kept.text;
  return json.dump(2, ' ', true, Json::error_handler_t::replace) + '\n';
}

KeptPlan plan_in(const Json& json) {
  KeptPlan kept{.scene = json.at("scene"),
                .file = json.at("file").get<std::string>(),
                .text = json.at("text"),
                .plan = {}};
  kept.plan.fixed = json.at("fixed").get<std::vector<std::string>>();
  for (const Json& axis : json.at("lists"))
    kept.plan.axes.push_back({axis.at("key"), axis.at("values")});
  return kept;
}

std::string words_of(const SweepPlan& plan) {
  std::vector<std::string> words = plan.fixed;
  for (const Axis& axis : plan.axes)
    words.push_back(fmt::format("{}={}", axis.key, fmt::join(axis.values, ",")));
  return fmt::format("{}", fmt::join(words, " "));
}

/// What may change while a run goes on has changed alone.
bool same_flow(const KeptPlan& older, const KeptPlan& now) {
  const Member first = members_of(now.plan).front();
  io::Scene then = scene_of(older, first);
  const io::Scene scene = scene_of(now, first);
  if (then.origin.step_chosen && scene.origin.step_chosen) then.time.dt = scene.time.dt;
  return io::flow_difference(then, scene).empty();
}

/// Whether a list may take the place of another.
bool may_replace(const KeptPlan& older, const KeptPlan& now, const RunOptions& options,
                 bool alone) {
  if (!alone && older.plan.axes != now.plan.axes) return false;
  return options.overwrite || (options.resume && (alone || same_flow(older, now)));
}

std::string described(const KeptPlan& older, const KeptPlan& now) {
  if (older.plan != now.plan) return "of other runs: " + words_of(older.plan);
  return fmt::format("of {} as it was before it was changed", older.file.string());
}

/// What can be done instead. Other tasks may be at work on the runs of another list.
std::string ways_out(const KeptPlan& older, const KeptPlan& now, bool alone) {
  if (alone || older.plan.axes == now.plan.axes)
    return "--overwrite replaces it, --out DIR leaves it alone";
  return "--out DIR leaves it alone; only a sweep without --only replaces it, with --overwrite";
}

}  // namespace

io::Scene scene_of(const KeptPlan& kept, const Member& member) {
  return io::parse_scene(kept.text, kept.file, methods(), all_overrides(kept.plan, member));
}

void keep_plan(const RunOptions& options, const SweepPlan& plan, bool alone) {
  const fs::path file = options.out / name;
  const KeptPlan now = plan_of(options, plan);
  if (io::write_new_text(file, page(now))) return;
  const KeptPlan older = kept_plan(options.out);
  if (older.plan == now.plan && older.text == now.text) return;
  if (!may_replace(older, now, options, alone))
    throw io::InputError(fmt::format("{} is the list {}; {}", file.string(), described(older, now),
                                     ways_out(older, now, alone)));
  io::write_text(file, page(now));
}

KeptPlan kept_plan(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw io::InputError(fmt::format("{}: no such folder", folder.string()));
  if (!fs::exists(folder / name, error))
    throw io::InputError(
        fmt::format("{}: there is no {}, which vortree run with a list of values leaves",
                    folder.string(), name));
  try {
    return plan_in(Json::parse(io::read_text(folder / name)));
  } catch (const Json::exception&) {
    throw io::InputError(fmt::format(
        "{}: is damaged; without it vortree run with the same list and --resume makes it again",
        (folder / name).string()));
  }
}

}  // namespace vortree::app
