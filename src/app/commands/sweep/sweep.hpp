#pragma once

#include <optional>

#include "app/commands/sweep/plan.hpp"
#include "app/commands/sweep/share.hpp"

namespace vortree::app {

/// Runs every combination of the values, the last key varying fastest, each into its own folder
/// `out/key=value[,key=value]`; prints the table of errors with their orders, and leaves sweep.csv
/// and its figures in `out`.
///
/// A run that fails is reported and leaves a gap in the table. With `resume`, runs go on from their
/// last frames and those that were not begun begin. The list is kept in sweep.json.
///
/// share    of a task beside others in the same folder, which runs its own and makes no table:
///          gather() does. None: all, alone
/// returns  0 if all runs came to their ends and missed no check, else 1: the last line says which
/// throws   as run() does, before anything runs; and if two runs would be the same
int sweep(const RunOptions& options, const SweepPlan& plan, const std::optional<Share>& share = {});

}  // namespace vortree::app
