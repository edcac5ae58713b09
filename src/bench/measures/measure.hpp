#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/clock.hpp"
#include "bench/measures/accuracy.hpp"
#include "bench/measures/methods.hpp"
#include "bench/sets/point_sets.hpp"

namespace vortree::bench {

/// What one method needed for one set.
struct Measurement {
  double seconds = 0.0;  // median of the repeats
  double fastest = 0.0;
  int repeats = 0;
  double cpu = 0.0;  // processor seconds a second during the repeats
  std::vector<std::pair<std::string, double>> phases;  // medians
  std::size_t targets = 0;           // fewer than blobs: the times were scaled up from so many
  std::optional<std::size_t> bytes;  // memory added by the first sum
  VelocityError error;
  Account account;
};

/// Seconds, fastest, repeats and phases of some laps, each time `scale` times what it was.
void summarise(std::span<const Stopwatch::Phases> laps, double scale, Measurement& made);

/// Repeats for so many seconds or so often, but three times at least.
///
/// most_pairs   an exact method sums at fewer targets if all would be more than twice as many pairs
struct Patience {
  double seconds = 0.5;
  int most_repeats = 50;
  double most_pairs = 1e9;
};

/// Sums once to warm up, then again and again.
///
/// exact    of the same set, at its own points
/// An exact method that sums at some targets only has those of `exact` among them.
/// throws   what the method throws
Measurement measure(const VelocityMethod& method, const PointSet& set, const Exact& exact,
                    double tolerance, const Patience& patience);

}  // namespace vortree::bench
