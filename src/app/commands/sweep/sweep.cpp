#include "app/commands/sweep/sweep.hpp"

#include <fmt/format.h>

#include <array>
#include <exception>
#include <map>
#include <new>
#include <numeric>
#include <span>
#include <utility>

#include "app/commands/sweep/plan_file.hpp"
#include "app/commands/sweep/report.hpp"
#include "app/commands/sweep/table.hpp"
#include "app/folder/older_run.hpp"
#include "app/folder/output_folder.hpp"
#include "app/install_paths.hpp"
#include "app/say.hpp"
#include "io/files.hpp"
#include "io/input_error.hpp"
#include "io/quote.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

RunOptions options_of(const RunOptions& all, const SweepPlan& plan, const Member& member) {
  RunOptions options = all;
  options.overrides = all_overrides(plan, member);
  options.out = all.out / folder_of(plan, member);
  options.resume = all.resume && holds_frames(options.out);
  options.figures = false;
  return options;
}

/// Two runs that differ in nothing that a run depends on make a table that says nothing.
void require_different(const RunOptions& options, const SweepPlan& plan,
                       std::span<const Member> members) {
  struct Known {
    std::string name;
    std::optional<double> accuracy;
  };
  std::map<std::string, Known> scenes;  // by all keys but the accuracy
  std::map<std::string, std::string> folders;
  for (const Member& m : members) {
    io::Scene scene = io::load_scene(find_scene(options.scene), methods(),
                                     options_of(options, plan, m).overrides);
    const Known known{name_of(plan, m), std::exchange(scene.accuracy, std::nullopt)};
    if (const auto [at, fresh] = scenes.emplace(io::resolved(scene), known); !fresh)
      throw io::InputError(fmt::format(
          "command line: {} is the same run as {}{}", known.name, at->second.name,
          known.accuracy == at->second.accuracy ? ""
                                                : ": all that an accuracy chooses is written"));
    if (const auto [at, fresh] = folders.emplace(folder_of(plan, m).string(), known.name); !fresh)
      throw io::InputError(
          fmt::format("command line: {} would run in the folder of {}", known.name, at->second));
  }
}

/// Leaves word of a failure in the folder of the run, as far as that can be done.
void keep_failure(const fs::path& folder, const std::string& failure) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return;
  try {
    io::write_derived_text(folder / "failed.txt", failure + "\n");
  } catch (const std::exception&) {  // what kept the run from its end may be a full disk
  }
}

/// Carries one out; what keeps it from its end is said, and kept.
void carry_out(const RunOptions& options, const SweepPlan& plan, Member& m) {
  const RunOptions own = options_of(options, plan, m);
  std::error_code error;
  try {
    if (fs::is_regular_file(own.out / "failed.txt", error)) io::remove_file(own.out / "failed.txt");
    m.result = run(own);
  } catch (const std::bad_alloc&) {
    m.failure = "out of memory";
  } catch (const std::exception& broken) {
    m.failure = broken.what();
  }
  if (m.failure.empty()) return;
  say_line(m.failure);
  keep_failure(own.out, m.failure);
}

/// throws  io::InputError if there is what the sweep, or a task's share of it, would destroy
void refuse_older_sweep(const RunOptions& options, const SweepPlan& plan,
                        std::span<const Member> members, std::span<const std::size_t> own,
                        bool alone) {
  std::error_code error;
  if (alone || !fs::exists(options.out / "sweep.json", error)) {
    refuse_older_table(options.out / "sweep.csv");
    refuse_older_figures(options.out, "sweep", options.figures_as);
  }
  for (const std::size_t k : own) refuse_older_run(options_of(options, plan, members[k]).out);
}

std::vector<std::size_t> all_of(std::span<const Member> members) {
  std::vector<std::size_t> all(members.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

int say_stopped(std::size_t run, std::size_t runs) {
  say("the sweep has stopped in run {} of {}", run, runs);
  return 1;
}

/// What became of a task's own runs; the table of all is another command's.
int end_of_task(const RunOptions& options, const SweepPlan& plan, std::span<const Member> members,
                std::span<const std::size_t> own) {
  std::vector<Member> done;
  for (const std::size_t k : own) done.push_back(members[k]);
  const std::string out = io::printable(options.out.string());
  tell("{} of {} runs are in {}; the table of all: vortree sweep {}\n", done.size(), members.size(),
       out, out);
  const std::string wrong = what_went_wrong(plan, done);
  if (!wrong.empty()) tell("{}\n", io::printable(wrong));
  return wrong.empty() ? 0 : 1;
}

}  // namespace

int sweep(const RunOptions& options, const SweepPlan& plan, const std::optional<Share>& share) {
  std::vector<Member> members = members_of(plan);
  const std::vector<std::size_t> own = share ? runs_of(*share, members.size()) : all_of(members);
  require_different(options, plan, members);  // before hours are spent on the first of them
  if (own.empty()) {
    tell("task {} of {} has nothing to do: the list has {} runs\n", share->task, share->tasks,
         members.size());
    return 0;
  }
  const bool alone = !share;
  const OutputFolder folder(options.out,
                            alone ? OutputFolder::Use::alone : OutputFolder::Use::shared);
  const fs::path table = options.out / "sweep.csv";
  if (alone) require_own_table(table);
  if (alone) io::require_writable(table, std::array{find_scene(options.scene)});
  if (!options.resume && !options.overwrite) refuse_older_sweep(options, plan, members, own, alone);
  keep_plan(options, plan, alone);
  if (alone && options.overwrite) remove_older_figures(options.out, "sweep");
  for (const std::size_t k : own) {
    Member& m = members[k];
    say("run {} of {}: {}", k + 1, members.size(), name_of(plan, m));
    carry_out(options, plan, m);
    if (m.ended() && !m.result.finished) return say_stopped(k + 1, members.size());
    if (alone) write_csv(table, options.scene, plan, std::span(members).first(k + 1));
  }
  return alone ? report(options.out, plan, members, options.figures_as)
               : end_of_task(options, plan, members, own);
}

}  // namespace vortree::app
