#include "app/commands/sweep/seconds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace vortree::app {
namespace {

constexpr std::array wanted_errors{0.01, 0.003, 0.001};
constexpr std::array errors_of_drag{"drag_max", "drag_rms"};

struct RunCost {
  double seconds, error;
};

/// Those that count, the cheapest first.
std::vector<RunCost> by_cost(std::span<const double> seconds, std::span<const double> errors) {
  std::vector<RunCost> runs;
  for (std::size_t k = 0; k < seconds.size(); ++k)
    if (seconds[k] > 0 && errors[k] > 0 && std::isfinite(seconds[k] * errors[k]))
      runs.push_back({seconds[k], errors[k]});
  std::ranges::sort(runs, {}, &RunCost::seconds);
  return runs;
}

/// Where the line between a run that errs more and one that does not comes to an error.
double seconds_between(const RunCost& more, const RunCost& less, double error) {
  const double share = std::log(more.error / error) / std::log(more.error / less.error);
  return more.seconds * std::pow(less.seconds / more.seconds, share);
}

std::string words(const std::optional<CostOfError>& cost) {
  if (!cost) return "not reached";
  return fmt::format("{}{:.3g}", cost->at_most ? "at most " : "", cost->seconds);
}

double seconds_of(const Member& m) {
  if (!m.ended()) return NAN;
  return m.result.threads == 1 ? m.result.processor_seconds : m.result.seconds;
}

double error_of(const Member& m, const std::string& what) {
  for (const checks::Verdict& v : m.result.verdicts)
    if (v.what == what) return v.reached.value.value_or(NAN);
  return NAN;
}

std::string line(std::span<const Member> group, const std::string& what, const std::string& of) {
  std::vector<double> seconds, errors;
  for (const Member& m : group) {
    seconds.push_back(seconds_of(m));
    errors.push_back(error_of(m, what));
  }
  if (by_cost(seconds, errors).size() < 2) return "";
  std::vector<std::string> asked, costs;
  for (const double wanted : wanted_errors) {
    asked.push_back(fmt::format("{:g} %", 100 * wanted));
    costs.push_back(words(cost_of_error(seconds, errors, wanted)));
  }
  return fmt::format("seconds to {} by {}{}: {}\n", fmt::join(asked, " / "), what, of,
                     fmt::join(costs, " / "));
}

/// What the runs of a group have in common, in words.
std::string shared_values(const SweepPlan& plan, const Member& m) {
  std::vector<std::string> same = overrides_of(plan, m);
  same.pop_back();
  return same.empty() ? "" : fmt::format(", {}", fmt::join(same, " "));
}

}  // namespace

std::optional<CostOfError> cost_of_error(std::span<const double> seconds,
                                         std::span<const double> errors, double wanted) {
  const std::vector<RunCost> runs = by_cost(seconds, errors);
  if (runs.empty() || runs.back().error > wanted) return std::nullopt;
  std::size_t first = runs.size() - 1;  // from this on none errs more
  while (first > 0 && runs[first - 1].error <= wanted) --first;
  if (first == 0) return CostOfError{runs[0].seconds, true};
  return CostOfError{seconds_between(runs[first - 1], runs[first], wanted), false};
}

std::string seconds_to_errors(const SweepPlan& plan, std::span<const Member> members) {
  std::string lines;
  const std::size_t size = plan.axes.back().values.size();
  if (!tells_the_same_flow(plan)) return lines;
  for (std::size_t first = 0; first < members.size(); first += size)
    for (const char* what : errors_of_drag)
      lines += line(members.subspan(first, std::min(size, members.size() - first)), what,
                    shared_values(plan, members[first]));
  return lines;
}

}  // namespace vortree::app
