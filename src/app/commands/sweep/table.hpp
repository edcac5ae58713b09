#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/commands/sweep/sweep.hpp"

namespace vortree::app {

/// One run of a sweep: a value for each axis, what came of it and, if it came to no end, why.
struct Member {
  std::vector<std::string> values;
  RunResult result{};
  std::string failure{};
};

/// key=value for each axis, and the same as one text.
std::vector<std::string> overrides_of(const SweepPlan& plan, const Member& member);
std::string name_of(const SweepPlan& plan, const Member& member);

/// Whether the last values make the same flow finer: between flows that differ there is no order.
bool tells_the_same_flow(const SweepPlan& plan);

/// Values, steps, particles, seconds and, of all that was held against an answer, what was reached
/// with the order between neighbors; for three runs and more the order that fits all. A gap is what
/// was not reached, or has no order: between flows that differ there is none.
std::string table(const SweepPlan& plan, std::span<const Member> members);

/// The same numbers with their origin, as CSV.
void write_csv(const std::filesystem::path& file, const RunOptions& options, const SweepPlan& plan,
               std::span<const Member> members);

/// One line: the runs that failed or missed their checks, the first few with the reason; nothing if
/// all went well.
std::string what_went_wrong(const SweepPlan& plan, std::span<const Member> members);

}  // namespace vortree::app
