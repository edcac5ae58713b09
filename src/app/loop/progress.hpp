#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace vortree::app {

/// Where a run stands after a step.
struct Progress {
  long step = 0;
  double time = 0.0, dt = 0.0;  // flow time and step
  double start = 0.0,
         end = 0.0;  // flow time at which this process began, and at which it will stop
  std::size_t particles = 0;
  std::string_view particle = "particle";  // what one is called
  double drift = 0.0;                      // largest relative drift of the invariants so far
};

/// The progress as one line without its end: step, time, dt, particles, time left, drift.
///
/// elapsed  seconds since this process began to step; the time left is that of the flow time done
/// so far, extended
std::string progress_line(const Progress& progress, double elapsed);

/// Shows progress on standard error: on a terminal a line that changes, five times a second at
/// most; elsewhere, as in the log of a cluster, a line of its own every half minute, with the time
/// of day at which a run will end as far as it can be told.
class ProgressLine {
 public:
  using Clock = std::chrono::steady_clock;

  ProgressLine();
  ProgressLine(bool terminal, Clock::duration between);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);
  void show_line(std::string_view line);

  /// Removes the line, so that a message can be written in its place.
  void clear();

 private:
  bool due();
  void write(std::string_view line);

  bool terminal_, shown_ = false;
  Clock::duration between_;
  Clock::time_point start_ = Clock::now(), last_;
};

}  // namespace vortree::app
