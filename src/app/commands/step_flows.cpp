#include "app/commands/step_flows.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "app/folder/run_files.hpp"
#include "app/install_paths.hpp"
#include "app/methods/methods.hpp"
#include "app/say.hpp"
#include "base/free_memory.hpp"
#include "io/frames/frames.hpp"
#include "io/scene/schema.hpp"

namespace vortree::app {

namespace fs = std::filesystem;
using bench::FlowState, bench::StepFlow, bench::StepVariant;

namespace {

/// Other settings of a scene; none: as it is.
struct OtherSettings {
  const char* name;
  const char* override;
};
constexpr std::array variants{OtherSettings{"fmm", nullptr},
                              OtherSettings{"boxes", "velocity.method=boxes"},
                              OtherSettings{"direct", "velocity.method=direct"},
                              OtherSettings{"unmerged", "merging.tolerance=0"}};

/// A scene that comes with the program, and when its flow is in full swing.
struct ShippedFlow {
  const char* scene;
  double accuracy, time;
};
constexpr std::array in_full_swing{ShippedFlow{"cylinder_re550_quick", 0.01, 3},
                                   ShippedFlow{"cylinder_re200", 0.02, 25},
                                   ShippedFlow{"naca0012", 0.01, 4}};
constexpr std::array soon_there{ShippedFlow{"cylinder_re550_quick", 0.02, 1.5},
                                ShippedFlow{"cylinder_re200", 0.04, 5},
                                ShippedFlow{"naca0012", 0.04, 1}};

/// Of a flow, those that are like no later ones: they have parts, and initial vorticity merges.
constexpr long first_steps = 16;

std::unique_ptr<flow::Solver> solver_of(const io::Scene& scene) {
  return scene.computed_by().begin(scene, machine_memory());
}

/// The scene with a setting in place of its own: all else stays, what an accuracy has chosen too.
StepVariant variant_of(const io::Scene& scene, const OtherSettings& other) {
  std::vector<std::string> overrides;
  if (other.override) overrides.emplace_back(other.override);
  return {other.name, [scene = io::parse_scene(io::resolved(scene), scene.origin.path, methods(),
                                               overrides)] { return solver_of(scene); }};
}

StepFlow flow_of(std::string name, const io::Scene& scene, FlowState from) {
  StepFlow made{.name = std::move(name),
                .panels = scene.body ? scene.body->panels : 0,
                .scales = flow::scales_of(scene),
                .from = std::move(from)};
  for (const OtherSettings& other : variants) made.variants.push_back(variant_of(scene, other));
  return made;
}

StepFlow followed(const ShippedFlow& flow, std::size_t largest) {
  const std::vector<std::string> accuracy{fmt::format("accuracy={}", flow.accuracy)};
  const io::Scene scene = io::load_scene(find_scene(flow.scene), methods(), accuracy);
  const std::size_t most = largest > 0 ? largest : std::numeric_limits<std::size_t>::max();
  const auto solver = solver_of(scene);
  const auto under_way = [&] {
    return solver->steps() < first_steps || solver->particles() < most;
  };
  while (solver->time() < flow.time && under_way()) solver->step([](std::string_view) {});
  FlowState from{.steps = solver->steps(), .columns = solver->columns()};
  solver->save(from.state);
  return flow_of(flow.scene, scene, std::move(from));
}

/// Of a run as its folder has it.
io::Scene kept_scene(const fs::path& folder) {
  const fs::path frames = folder / "frames.h5";
  std::error_code error;
  if (!fs::exists(frames, error))
    throw io::InputError(fmt::format("{} holds no run: there is no frames.h5", folder.string()));
  io::Scene now = io::blank_scene(methods());
  now.origin.path = io::info_of_frames(frames).scene_path;
  io::Scene kept = scene_of_frames(frames, now);
  if (kept.method == methods().front()->name()) return kept;
  throw io::InputError(fmt::format("{}: a run by method = \"{}\"; steps are measured of vortices",
                                   folder.string(), kept.method));
}

/// What its last good frame holds, which must be enough to go on from.
FlowState last_state(const fs::path& folder, const io::Scene& scene) {
  const fs::path file = folder / "frames.h5";
  io::RecoveredFrames found = io::read_last_good(file);
  if (!found.warning.empty()) say("{}: {}", file.string(), found.warning);
  if (!found.last) throw io::InputError(file.string() + " has no frames");
  FlowState from{.steps = static_cast<long>(found.last->step),
                 .columns = std::move(found.last->columns),
                 .state = std::move(found.last->state)};
  try {
    solver_of(scene)->restore(from.steps, from.columns, from.state);
  } catch (const std::out_of_range& missing) {
    throw io::InputError(fmt::format("{}: {}; another version of the program has written it",
                                     file.string(), missing.what()));
  }
  return from;
}

std::string name_of(const fs::path& folder) {
  const fs::path plain = folder.lexically_normal();
  return (plain.has_filename() ? plain : plain.parent_path()).filename().string();
}

}  // namespace

std::vector<std::function<StepFlow()>> step_flows(const std::vector<fs::path>& runs, bool quick,
                                                  std::size_t largest) {
  std::vector<std::function<StepFlow()>> flows;
  for (const fs::path& folder : runs) {
    const io::Scene scene = kept_scene(folder);
    flows.emplace_back(
        [kept = flow_of(name_of(folder), scene, last_state(folder, scene))] { return kept; });
  }
  if (!runs.empty()) return flows;
  for (const ShippedFlow& flow : quick ? soon_there : in_full_swing)
    flows.emplace_back([flow, largest] { return followed(flow, largest); });
  return flows;
}

}  // namespace vortree::app
