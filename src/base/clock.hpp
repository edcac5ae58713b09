#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vortree {

/// Wall time since it was made, and wall time by phase.
///
///   Stopwatch watch;
///   step(..., [&](std::string_view phase) { watch.begin(phase); });
///   watch.end();
///   watch.seconds("convect")         // all laps of that phase together
template <class Clock>
class StopwatchBy {
 public:
  using Phases = std::vector<std::pair<std::string, double>>;

  /// Ends the phase that runs, if any, and begins another.
  void begin(std::string_view phase) {
    const auto now = Clock::now();
    close(now);
    current_ = phase;
    began_ = now;
  }

  /// Ends the phase that runs, if any: what follows belongs to none.
  void end() { close(Clock::now()); }

  /// Seconds since the stopwatch was made.
  double elapsed() const { return seconds(start_, Clock::now()); }

  /// Seconds of the laps of a phase that have ended, 0 if there are none.
  double seconds(std::string_view name) const {
    for (const auto& [phase, total] : phases_)
      if (phase == name) return total;
    return 0.0;
  }

  /// Every phase with its seconds, in the order in which they first ended.
  const Phases& phases() const { return phases_; }

 private:
  using Moment = typename Clock::time_point;

  static double seconds(Moment from, Moment to) {
    return std::chrono::duration<double>(to - from).count();
  }

  void close(Moment now) {
    if (current_.empty()) return;
    slot(current_) += seconds(began_, now);
    current_.clear();
  }

  double& slot(std::string_view name) {
    for (auto& [phase, total] : phases_)
      if (phase == name) return total;
    return phases_.emplace_back(name, 0.0).second;
  }

  Moment start_ = Clock::now(), began_ = start_;
  std::string current_;
  Phases phases_;
};

using Stopwatch = StopwatchBy<std::chrono::steady_clock>;

/// The middle one of some values, or the mean of the middle two; one at least.
inline double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

/// What all threads of the process have worked since it began [s].
inline double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace vortree
