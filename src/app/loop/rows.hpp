#pragma once

#include <functional>
#include <string>
#include <vector>

#include "flow/solver.hpp"

namespace vortree::app {

/// The rows of report.csv: t, T = U t/R, what the method measures, the coefficients of the body's
/// force (without one 0, and fewer), or of all bodies' and then of each, seconds since the start
/// and by phase of the step. A row waits for the step after it, since a force is a rate of change;
/// that of the start, which has no force, is left out.
///
/// solver  the flow that is measured; it outlives the rows
class Rows {
 public:
  using Write = std::function<void(const std::vector<double>& row)>;

  Rows(const flow::Solver& solver, const flow::Scales& scales);

  /// Of the columns, in their order.
  std::vector<std::string> names() const;

  /// The flow as it is now, and the seconds that it took: all, and by phase in the order of
  /// `phases`. Writes the row before.
  void add(const std::vector<double>& seconds, const Write& write);

  /// Writes the last row.
  void finish(const Write& write) const;

  /// Phases of a step: those of the method, and output.
  std::vector<std::string> phases() const;

  void save(flow::State& state) const;

  /// After the flow has been restored.
  void restore(const flow::State& state);

 private:
  struct Row {
    double t = 0;
    flow::Measures measures;
    std::vector<double> seconds;
  };

  std::vector<std::string> seconds_names() const;
  flow::Measures no_force() const;
  flow::Measures told(flow::Measures (flow::ForceHistory::*of)() const) const;
  Row now(std::vector<double> seconds) const;
  std::vector<double> whole(const Row& row, const flow::Measures& coefficients) const;

  const flow::Solver& solver_;
  flow::Scales scales_;
  flow::ForceHistory forces_;
  std::vector<flow::ForceHistory> on_each_;  // of several bodies
  Row waiting_;
  int known_ = 0;  // rows so far, three at most
};

}  // namespace vortree::app
