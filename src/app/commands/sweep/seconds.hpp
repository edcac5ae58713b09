#pragma once

#include <optional>
#include <span>
#include <string>

#include "app/commands/sweep/table.hpp"

namespace vortree::app {

/// What an error costs by a sweep's runs: the seconds at which the straight line between two of
/// them, both scales logarithmic, comes down to it and no dearer run errs more.
///
/// at_most  the cheapest run errs no more already: fewer seconds may do
struct CostOfError {
  double seconds;
  bool at_most;
};

/// Runs in any order; those that have no time or no error do not count.
/// returns  none if the dearest run errs more: nothing is extrapolated
std::optional<CostOfError> cost_of_error(std::span<const double> seconds,
                                         std::span<const double> errors, double wanted);

/// A line for each group of runs that differ in their last value alone, of numbers, and for each
/// error of the drag that was held against a reference:
///
///     seconds to 1 % / 0.3 % / 0.1 % by drag_max: at most 1.6 / 3.8 / not reached
///
/// Seconds of the processor where one thread is at work, as it may serve others, else those of the
/// clock. Nothing if there are no such errors.
std::string seconds_to_errors(const SweepPlan& plan, std::span<const Member> members);

}  // namespace vortree::app
