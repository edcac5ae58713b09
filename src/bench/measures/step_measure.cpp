#include "bench/measures/step_measure.hpp"

#include <algorithm>

#include "base/clock.hpp"
#include "flow/force_history.hpp"

namespace vortree::bench {
namespace {

/// Phases of each of some steps.
using StepLaps = std::vector<Stopwatch::Phases>;

/// What comes before a step names its first phase belongs to that.
Stopwatch::Phases timed_step(flow::Solver& solver) {
  Stopwatch watch;
  watch.begin(solver.phases().front());
  solver.step([&](std::string_view phase) { watch.begin(phase); });
  watch.end();
  return watch.phases();
}

StepLaps timed_steps(flow::Solver& solver, const FlowState& from, int steps) {
  solver.restore(from.steps, from.columns, from.state);
  StepLaps laps;
  for (int k = 0; k < steps; ++k) laps.push_back(timed_step(solver));
  return laps;
}

double seconds_of(const Stopwatch::Phases& phases, std::string_view wanted) {
  for (const auto& [name, seconds] : phases)
    if (name == wanted) return seconds;
  return 0;
}

double seconds_of(const StepLaps& laps) {
  double sum = 0;
  for (const Stopwatch::Phases& step : laps)
    for (const auto& [name, seconds] : step) sum += seconds;
  return sum;
}

/// Of the step `k`, the median of the repeats.
double median_of(std::span<const StepLaps> repeats, std::size_t k, std::string_view phase) {
  std::vector<double> seconds;
  for (const StepLaps& laps : repeats) seconds.push_back(seconds_of(laps[k], phase));
  return median(seconds);
}

/// As the first step has it: no later one is known.
std::optional<double> drag_of(const flow::Solver& solver, flow::ForceHistory& forces) {
  const auto force = solver.force();
  if (!force) return std::nullopt;
  forces.add(*force);
  return flow::measured(forces.of_last(), "cd_" + solver.route());
}

void add(flow::Measures& sums, const flow::Measures& counts) {
  if (sums.empty()) return void(sums = counts);
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k].value += counts[k].value;
}

/// The steps once, for what they do and not for how long.
StepMeasure counted(flow::Solver& solver, const FlowState& from, const flow::Scales& scales,
                    const StepPatience& patience) {
  StepMeasure made;
  solver.restore(from.steps, from.columns, from.state);
  flow::ForceHistory forces(scales);
  if (const auto force = solver.force()) forces.add(*force);
  const double most = patience.growth * static_cast<double>(solver.particles());
  for (double now = 0; made.steps == 0 || (made.steps < patience.steps && now < most);
       ++made.steps) {
    solver.step([](std::string_view) {});
    if (made.steps == 0) made.drag = drag_of(solver, forces);
    now = static_cast<double>(solver.particles());
    made.particles += now;
    add(made.counts, solver.counts());
  }
  for (flow::Measure& one : made.counts) one.value /= made.steps;
  return made;
}

/// The steps of one solver.
class RepeatedSteps {
 public:
  RepeatedSteps(flow::Solver& solver, const FlowState& from, const flow::Scales& scales,
                const StepPatience& patience)
      : solver_(solver),
        from_(from),
        patience_(patience),
        made_(counted(solver, from, scales, patience)) {}

  bool patient() const {
    return spent_ < patience_.seconds && made_.repeats < patience_.most_repeats;
  }

  void repeat() {
    repeats_.push_back(timed_steps(solver_, from_, made_.steps));
    spent_ += seconds_of(repeats_.back());
    ++made_.repeats;
  }

  StepMeasure measure() const {
    StepMeasure made = made_;
    std::vector<std::string> names = solver_.phases();
    names.emplace_back("output");
    for (const std::string& phase : names) made.phases.emplace_back(phase, seconds(phase));
    return made;
  }

 private:
  double seconds(std::string_view phase) const {
    double sum = 0;
    for (std::size_t k = 0; k < repeats_.front().size(); ++k) sum += median_of(repeats_, k, phase);
    return sum;
  }

  flow::Solver& solver_;
  const FlowState& from_;
  const StepPatience& patience_;
  StepMeasure made_;
  std::vector<StepLaps> repeats_;
  double spent_ = 0;
};

}  // namespace

double StepMeasure::seconds() const {
  double sum = 0;
  for (const auto& [name, seconds] : phases) sum += seconds;
  return sum;
}

std::vector<StepMeasure> measure_steps(std::span<flow::Solver* const> solvers,
                                       const FlowState& from, const flow::Scales& scales,
                                       const StepPatience& patience) {
  std::vector<RepeatedSteps> contest;
  for (flow::Solver* solver : solvers) contest.emplace_back(*solver, from, scales, patience);
  const auto more = [&](const RepeatedSteps& one) { return one.patient(); };
  while (std::ranges::any_of(contest, more))
    for (RepeatedSteps& one : contest)
      if (one.patient()) one.repeat();
  std::vector<StepMeasure> made;
  for (const RepeatedSteps& one : contest) made.push_back(one.measure());
  return made;
}

}  // namespace vortree::bench
