#pragma once

#include <filesystem>
#include <string>

#include "app/commands/sweep/plan.hpp"

namespace vortree::app {

/// A list of runs as the folder of a sweep keeps it, in sweep.json, so that several tasks that work
/// on it are known to work on the same, and their table can be made without them.
///
/// scene  as the user named it
/// file   of the scene, from the root on; text: what stood there
struct KeptPlan {
  std::string scene;
  std::filesystem::path file;
  std::string text;
  SweepPlan plan;
};

/// Keeps the list in the folder, or finds it there.
///
/// alone  nobody else works on it. Then --resume and --overwrite put it in place of another; of
///        several tasks only one of the same keys and values, and with --resume of the same flow
/// throws  io::InputError if the folder has another list
void keep_plan(const RunOptions& options, const SweepPlan& plan, bool alone);

/// throws  io::InputError if there is none, or a damaged one
KeptPlan kept_plan(const std::filesystem::path& folder);

/// The scene of one run of the list.
/// throws  io::InputError if files that it names are not there any more
io::Scene scene_of(const KeptPlan& kept, const Member& member);

}  // namespace vortree::app
