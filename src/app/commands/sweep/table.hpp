#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/commands/sweep/plan.hpp"

namespace vortree::app {

/// Whether the last values make the same flow finer: between flows that differ there is no order.
bool tells_the_same_flow(const SweepPlan& plan);

/// Values, steps, particles, seconds and, of all that was held against an answer, what was reached
/// with the order between neighbors; for three runs and more the order that fits all. A gap is what
/// was not reached, or has no order: between flows that differ there is none.
std::string table(const SweepPlan& plan, std::span<const Member> members);

/// throws  io::InputError if the table's name is a link to what is no table of a sweep: a file of
///         another suffix, or one in the folder of a run
void require_own_table(const std::filesystem::path& file);

/// The same numbers as CSV, with where they come from: of runs on several machines each.
///
/// scene  as the user named it
void write_csv(const std::filesystem::path& file, const std::string& scene, const SweepPlan& plan,
               std::span<const Member> members);

/// One line: the runs that failed, are not at their ends, have not begun or missed their checks,
/// the first few with the reason; nothing if all went well.
std::string what_went_wrong(const SweepPlan& plan, std::span<const Member> members);

}  // namespace vortree::app
