#pragma once

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
};

/// `key=a,b,c` is an axis; commas inside brackets or quotes divide nothing.
/// throws  io::InputError for an empty value between two commas
SweepPlan sweep_plan(std::span<const std::string> overrides);

/// Runs every combination of the values, the last key varying fastest, each into its own folder
/// `out/key=value[,key=value]`; prints the table of errors with their orders, and leaves sweep.csv
/// and its figures in `out`.
///
/// A run that fails is reported and leaves a gap in the table. With `resume`, runs go on from their
/// last frames and those that were not begun begin.
/// returns  0 if all runs came to their ends and missed no check, else 1: the last line says which
/// throws   as run() does, before anything runs; and if two runs would be the same
int sweep(const RunOptions& options, const SweepPlan& plan);

}  // namespace vortree::app
