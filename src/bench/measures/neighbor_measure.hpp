#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "bench/sets/particle_sets.hpp"
#include "neighbors/methods.hpp"

namespace vortree::bench {

/// What a list holds, whatever the order of its rows: as many pairs, and a sum of hashes of all of
/// them; of unordered pairs if each stands there once.
struct Fingerprint {
  std::uint64_t pairs = 0, sum = 0;
  bool operator==(const Fingerprint&) const = default;
};
[[nodiscard]] Fingerprint fingerprint(const tree::PairList& rows, tree::Listing listing);

/// What one method needed for one set: seconds of the median of the repeats.
///
/// bytes        memory that the first search added, its list included
/// list_bytes   of those, the list
/// cpu          processor seconds a second during the repeats
struct NeighborMeasurement {
  double build = 0, search = 0, total = 0, fastest = 0, cpu = 0;
  int repeats = 0;
  std::optional<std::size_t> bytes;
  std::size_t list_bytes = 0;
  Fingerprint found;
};

/// Searches once to warm up, then again and again, as the steps of a flow do: the same object, the
/// same buffers.
///
/// seconds   repeats for so long, three times at least; twice if one search takes longer than this
NeighborMeasurement measure_neighbors(const neighbors::NeighborMaker& maker,
                                      const neighbors::NeighborJob& job, double seconds);

/// What a set of n particles costs [s].
struct NeighborCost {
  double n, seconds;
};
struct Slope {
  double exponent, from, to;
};

/// The exponent of n in cost, fitted from 10^4 particles on (least squares of the logarithms);
/// nothing for fewer than three numbers of particles.
[[nodiscard]] std::optional<Slope> fit_slope(std::span<const NeighborCost> costs);

/// Seconds that a search will take, roughly, before it is made: so that nobody waits for hours.
/// From the pairs it tests: all, or those of cells as wide as the largest reach; else some
/// microseconds a particle.
[[nodiscard]] double expected_seconds(const neighbors::NeighborMaker& maker,
                                      const neighbors::NeighborJob& job);

}  // namespace vortree::bench
