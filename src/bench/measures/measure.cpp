#include "bench/measures/measure.hpp"

#include <algorithm>

#include "bench/measures/memory.hpp"

namespace vortree::bench {
namespace {

// Where a sum of every pair is asked for: everywhere, or where the truth is known and at the first
// points beside.
std::vector<std::size_t> some_targets(std::size_t n, const Exact& exact, double most_pairs) {
  const auto wanted = static_cast<std::size_t>(most_pairs / static_cast<double>(n));
  std::vector<std::size_t> chosen = exact.targets;
  for (std::size_t i = 0; i < n && chosen.size() < wanted; ++i) chosen.push_back(i);
  return chosen;
}

// The same truth, at the first of fewer targets.
Exact at_first(Exact exact) {
  for (std::size_t k = 0; k < exact.targets.size(); ++k) exact.targets[k] = k;
  return exact;
}

double total(const Stopwatch::Phases& lap) {
  double sum = 0.0;
  for (const auto& [name, seconds] : lap) sum += seconds;
  return sum;
}

double seconds_of(const Stopwatch::Phases& lap, const std::string& phase) {
  for (const auto& [name, seconds] : lap)
    if (name == phase) return seconds;
  return 0;
}

}  // namespace

void summarise(std::span<const Stopwatch::Phases> laps, double scale, Measurement& made) {
  std::vector<double> totals;
  for (const auto& lap : laps) totals.push_back(scale * total(lap));
  made.seconds = median(totals);
  made.fastest = std::ranges::min(totals);
  made.repeats = static_cast<int>(laps.size());
  for (const auto& [name, ignored] : laps.front()) {
    std::vector<double> values;
    for (const auto& lap : laps) values.push_back(scale * seconds_of(lap, name));
    made.phases.emplace_back(name, median(values));
  }
}

Measurement measure(const VelocityMethod& method, const PointSet& set, const Exact& exact,
                    double tolerance, const Patience& patience) {
  const auto n = static_cast<double>(set.size());
  const bool partly = method.exact && n * n > 2.0 * patience.most_pairs;
  const std::vector<std::size_t> chosen =
      partly ? some_targets(set.size(), exact, patience.most_pairs) : std::vector<std::size_t>{};
  std::vector<double> x, y;
  for (const std::size_t i : chosen) x.push_back(set.x[i]), y.push_back(set.y[i]);
  const fmm::Targets targets = partly ? fmm::Targets{x, y, {}} : fmm::Targets{set.x, set.y, {}};
  std::vector<double> u(targets.size()), v(targets.size());
  const VelocitySum sum{set.blobs(), targets, partly, u, v};

  Measurement made;
  made.targets = targets.size();
  const auto lap = [&](bool counted) {
    Stopwatch watch;
    Account account = method.sum(sum, {.tolerance = tolerance},
                                 [&watch](std::string_view name) { watch.begin(name); },
                                 {.repeated = true, .counted = counted});
    if (counted) made.account = account;
    return watch.phases();
  };
  const MemoryGrowth growth;
  lap(true);
  made.bytes = growth.bytes();

  std::vector<Stopwatch::Phases> laps;
  const double used = processor_seconds();
  const Stopwatch all;
  for (double spent = 0.0;
       laps.size() < 3 ||
       (spent < patience.seconds && static_cast<int>(laps.size()) < patience.most_repeats);)
    spent += total(laps.emplace_back(lap(false)));
  made.cpu = (processor_seconds() - used) / all.elapsed();
  summarise(laps, n / static_cast<double>(targets.size()), made);
  made.error = velocity_error(partly ? at_first(exact) : exact, u, v);
  return made;
}

}  // namespace vortree::bench
