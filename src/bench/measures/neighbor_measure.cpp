#include "bench/measures/neighbor_measure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/clock.hpp"
#include "base/random.hpp"
#include "bench/measures/memory.hpp"

namespace vortree::bench {
namespace {

// Of cells as wide as the largest reach: the particles of each, squared.
double crowding(const neighbors::NeighborJob& job) {
  const double side = std::max(std::ranges::max(job.reach), 1e-300);
  const auto [left, right] = std::ranges::minmax(job.points.x);
  const auto [low, high] = std::ranges::minmax(job.points.y);
  const double columns = std::floor((right - left) / side) + 1;
  const double rows = std::floor((high - low) / side) + 1;
  if (columns * rows > 4.0 * static_cast<double>(job.points.size())) return 0;
  std::vector<double> count(static_cast<std::size_t>(columns * rows));
  for (std::size_t i = 0; i < job.points.size(); ++i) {
    const double row = std::floor((job.points.y[i] - low) / side);
    ++count[static_cast<std::size_t>(row * columns + (job.points.x[i] - left) / side)];
  }
  double sum = 0;
  for (const double c : count) sum += c * c;
  return sum;
}

}  // namespace

Fingerprint fingerprint(const tree::PairList& rows, tree::Listing listing) {
  std::uint64_t sum = 0;
  const bool once = listing == tree::Listing::once;
#pragma omp parallel for schedule(static) reduction(+ : sum)
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const std::int32_t number : rows.row(i)) {
      const auto j = static_cast<std::size_t>(number);
      sum += once && j < i ? splitmix64(j << 32 | i) : splitmix64(i << 32 | j);
    }
  }
  return {rows.index.size(), sum};
}

NeighborMeasurement measure_neighbors(const neighbors::NeighborMaker& maker,
                                      const neighbors::NeighborJob& job, double seconds) {
  const auto method = maker.make();
  tree::PairList rows;
  std::vector<double> build, search, total;
  const auto lap = [&] {
    Stopwatch watch;
    watch.begin("build");
    method->build(job);
    watch.begin("search");
    method->search(job, rows);
    watch.end();
    build.push_back(watch.seconds("build"));
    search.push_back(watch.seconds("search"));
    total.push_back(build.back() + search.back());
  };
  NeighborMeasurement made;
  const MemoryGrowth growth;
  lap();
  made.bytes = growth.bytes();
  made.list_bytes =
      rows.start.size() * sizeof(std::int64_t) + rows.index.size() * sizeof(std::int32_t);
  made.found = fingerprint(rows, job.listing);

  const bool slow = total.back() > seconds;
  build.clear(), search.clear(), total.clear();
  const double used = processor_seconds();
  const Stopwatch all;
  while (total.size() < (slow ? 2 : 3) || (all.elapsed() < seconds && total.size() < 200)) lap();
  made.cpu = (processor_seconds() - used) / all.elapsed();
  made.build = median(build), made.search = median(search), made.total = median(total);
  made.fastest = std::ranges::min(total);
  made.repeats = static_cast<int>(total.size());
  return made;
}

std::optional<Slope> fit_slope(std::span<const NeighborCost> costs) {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0, from = INFINITY, to = 0;
  for (const auto [n, seconds] : costs) {
    if (n < 9900) continue;
    const double u = std::log(n), v = std::log(seconds);
    ++count, x += u, y += v, xx += u * u, xy += u * v;
    from = std::min(from, n), to = std::max(to, n);
  }
  if (count < 3 || !(to > from)) return {};
  return Slope{(count * xy - x * y) / (count * xx - x * x), from, to};
}

double expected_seconds(const neighbors::NeighborMaker& maker, const neighbors::NeighborJob& job) {
  const auto n = static_cast<double>(job.points.size());
  if (maker.quadratic) return 0.7e-9 * n * n;
  // Nine cells, by vectors; five, each pair once, by chains.
  if (maker.name() == "uniform-grid") return 9 * 0.4e-9 * crowding(job);
  if (maker.name() == "linked-list") return 4.5 * 4e-9 * crowding(job);
  const bool by_grids = maker.name() == "qcg" || maker.name() == "level-grids";
  return n * (by_grids ? 0.3e-6 : 8e-6);
}

}  // namespace vortree::bench
