#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace vortree::app {

/// Where a run stands after a step.
struct Progress {
  long step = 0;
  double time = 0.0, dt = 0.0;  // flow time and step
  double start = 0.0,
         end = 0.0;  // flow time at which this process began, and at which it will stop
  std::size_t particles = 0;
  double drift = 0.0;  // largest relative drift of the invariants so far
};

/// The progress as one line without its end: step, time, dt, particles, time left, drift.
///
/// elapsed  seconds since this process began to step; the time left is that of the flow time done
/// so far, extended
std::string progress_line(const Progress& progress, double elapsed);

/// Shows progress on standard error, five times a second at most; silent where that is not a
/// terminal.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);

  /// Removes the line, so that a message can be written in its place.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_, shown_ = false;
  Clock::time_point start_ = Clock::now(), last_{};
};

}  // namespace vortree::app
