#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "app/commands/sweep/plan.hpp"

namespace vortree::app {

/// The end of a sweep whose sweep.csv is in the folder: prints the table, what errors cost, and
/// what went wrong, and draws the figures.
/// formats  of the figures; none: png
/// returns  0 if all runs came to their ends and missed no check, else 1
int report(const std::filesystem::path& folder, const SweepPlan& plan,
           std::span<const Member> members, std::span<const std::string> formats);

}  // namespace vortree::app
