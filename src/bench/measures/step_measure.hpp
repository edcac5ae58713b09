#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "flow/scales.hpp"
#include "flow/solver.hpp"

namespace vortree::bench {

/// A flow in the midst of its way, as Solver::restore takes it.
struct FlowState {
  long steps = 0;
  flow::Columns columns{};
  flow::State state{};
};

/// How many steps, and how long they are repeated: for so many seconds, so often at most. Where
/// particles multiply, as blobs do that split around a sharp edge and never merge, the steps end
/// when there are `growth` times as many as at first.
struct StepPatience {
  int steps = 8;
  double growth = 2;
  double seconds = 1;
  int most_repeats = 9;
};

/// What some steps of a flow needed and did.
///
/// phases    of all steps, the median over the repeats of each [s]; they are all of a step
/// particles after each step, summed over the steps
/// counts    Solver::counts(), a step in the mean
/// drag      coefficient during the first step by the method's own route; none without a body
struct StepMeasure {
  std::vector<std::pair<std::string, double>> phases{};
  double particles = 0;
  int steps = 0, repeats = 0;
  flow::Measures counts{};
  std::optional<double> drag{};

  double seconds() const;
};

/// Each of several solvers does the same steps again and again from the same state, by turns: what
/// disturbs the machine disturbs all. The first time, which warms memory up, counts for none. Steps
/// differ, for lattices are laid in some of them only, but each is the same to the bit every time:
/// medians over the repeats take out the noise of the machine, and leave the work that comes by
/// turns.
///
/// returns  a measure a solver
/// throws   what a Solver throws
std::vector<StepMeasure> measure_steps(std::span<flow::Solver* const> solvers,
                                       const FlowState& from, const flow::Scales& scales,
                                       const StepPatience& patience);

}  // namespace vortree::bench
