#include "app/commands/sweep/sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <exception>
#include <map>
#include <new>
#include <optional>
#include <utility>

#include "app/commands/sweep/seconds.hpp"
#include "app/commands/sweep/table.hpp"
#include "app/folder/older_run.hpp"
#include "app/folder/output_folder.hpp"
#include "app/install_paths.hpp"
#include "app/plot.hpp"
#include "app/say.hpp"
#include "io/files.hpp"
#include "io/input_error.hpp"
#include "io/quote.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_runs = 10'000;

/// The parts of a list between commas that are not inside brackets or quotes.
std::vector<std::string> listed(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = 0;
  for (char c : text) {
    if (quote) {
      quote = c == quote ? 0 : quote;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == ',' && depth == 0) {
      parts.emplace_back();
      continue;
    }
    parts.back() += c;
  }
  return parts;
}

std::vector<Member> members_of(const SweepPlan& plan) {
  std::vector<Member> members(1);
  for (const Axis& axis : plan.axes) {
    if (members.size() * axis.values.size() > most_runs)
      throw io::InputError(
          fmt::format("command line: a sweep of more than {} runs, by {}", most_runs, axis.key));
    std::vector<Member> more;
    for (const Member& m : members)
      for (const std::string& value : axis.values) {
        more.push_back(m);
        more.back().values.push_back(value);
      }
    members = std::move(more);
  }
  return members;
}

fs::path folder_of(const SweepPlan& plan, const Member& member) {
  std::string name = fmt::format("{}", fmt::join(overrides_of(plan, member), ","));
  std::ranges::replace_if(
      name, [](char c) { return c == '/' || c == ' ' || c == '"'; }, '_');
  return name;
}

RunOptions options_of(const RunOptions& all, const SweepPlan& plan, const Member& member) {
  RunOptions options = all;
  options.overrides = plan.fixed;
  for (const std::string& word : overrides_of(plan, member)) options.overrides.push_back(word);
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

/// Carries one out; what keeps it from its end is said, and kept.
void carry_out(const RunOptions& options, const SweepPlan& plan, Member& m) {
  try {
    m.result = run(options_of(options, plan, m));
  } catch (const std::bad_alloc&) {
    m.failure = "out of memory";
  } catch (const std::exception& broken) {
    m.failure = broken.what();
  }
  if (!m.failure.empty()) say_line(m.failure);
}

}  // namespace

SweepPlan sweep_plan(std::span<const std::string> overrides) {
  SweepPlan plan;
  for (const std::string& word : overrides) {
    const std::size_t equals = word.find('=');
    const auto values =
        equals == std::string::npos ? std::vector<std::string>{} : listed(word.substr(equals + 1));
    if (values.size() < 2) {
      plan.fixed.push_back(word);
      continue;
    }
    if (std::ranges::any_of(values, &std::string::empty))
      throw io::InputError(
          fmt::format("command line: {}: there is an empty value between two commas", word));
    plan.axes.push_back({word.substr(0, equals), values});
  }
  return plan;
}

int sweep(const RunOptions& options, const SweepPlan& plan) {
  std::vector<Member> members = members_of(plan);
  require_different(options, plan, members);  // before hours are spent on the first of them
  const OutputFolder folder(options.out);
  io::require_writable(options.out / "sweep.csv", std::array{find_scene(options.scene)});
  if (!options.resume && !options.overwrite) {
    refuse_older_table(options.out / "sweep.csv");
    refuse_older_figures(options.out, "sweep");
    for (const Member& m : members) refuse_older_run(options_of(options, plan, m).out);
  }
  if (options.overwrite) remove_older_figures(options.out, "sweep");
  std::size_t done = 0;
  for (Member& m : members) {
    say("run {} of {}: {}", done + 1, members.size(), name_of(plan, m));
    carry_out(options, plan, m);
    if (m.failure.empty() && !m.result.finished) {
      say("the sweep has stopped in run {} of {}", done + 1, members.size());
      return 1;
    }
    write_csv(options.out / "sweep.csv", options, plan, std::span(members).first(++done));
  }
  tell("{}{}", table(plan, members), seconds_to_errors(plan, members));
  plot(options.out, "sweep");
  tell("results in {}\n", io::printable(options.out.string()));
  const std::string wrong = what_went_wrong(plan, members);
  if (!wrong.empty()) tell("{}\n", io::printable(wrong));
  return wrong.empty() ? 0 : 1;
}

}  // namespace vortree::app
