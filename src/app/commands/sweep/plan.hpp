#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/loop/run.hpp"

namespace vortree::app {

/// A key of a scene that takes several values in turn.
struct Axis {
  std::string key;
  std::vector<std::string> values;
  bool operator==(const Axis&) const = default;
};

/// What a command line asks for: overrides that hold throughout, and the keys that vary.
struct SweepPlan {
  std::vector<std::string> fixed;
  std::vector<Axis> axes;

  bool empty() const { return axes.empty(); }
  bool operator==(const SweepPlan&) const = default;
};

/// `key=a,b,c` is an axis; commas inside brackets or quotes divide nothing.
/// throws  io::InputError for an empty value between two commas
SweepPlan sweep_plan(std::span<const std::string> overrides);

/// Why a run of a sweep has come to no end.
enum class Lack { failed, unfinished, missing };

/// One run of a sweep: a value for each axis, what came of it and, if it came to no end, why.
///
/// lack  counts beside a failure only
struct Member {
  std::vector<std::string> values;
  RunResult result{};
  std::string failure{};
  Lack lack = Lack::failed;

  bool ended() const { return failure.empty(); }
};

/// Every combination of the values, the last key varying fastest.
/// throws  io::InputError if there are more than 10000
std::vector<Member> members_of(const SweepPlan& plan);

/// key=value for each axis, and the same as one text.
std::vector<std::string> overrides_of(const SweepPlan& plan, const Member& member);
std::string name_of(const SweepPlan& plan, const Member& member);

/// The folder of a run within that of its sweep: key=value[,key=value].
std::filesystem::path folder_of(const SweepPlan& plan, const Member& member);

/// All that the run is told: what holds throughout, then its own values.
std::vector<std::string> all_overrides(const SweepPlan& plan, const Member& member);

}  // namespace vortree::app
