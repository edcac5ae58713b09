#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vortree::bench {

/// Points of 2 or 3 dimensions, coordinate by coordinate.
using Coordinates = std::vector<std::vector<double>>;

/// Lists of neighbors nearer than one reach for all, naively: each of the n (n - 1) / 2 pairs
/// tested once and entered in the lists of both.
///
/// source  Kollasch & Santoro 2023, second listing
[[nodiscard]] std::vector<std::vector<std::int32_t>> neighbors_naive(const Coordinates& points,
                                                                     double reach);

/// The same by cells as wide as the reach: particles counted into cells, each tested against those
/// of the 9 or 27 cells around its own that come after it.
///
/// cost    O(n), where the paper's version scanned all later particles for each of 27 cells
/// source  Kollasch & Santoro 2023, corrected
[[nodiscard]] std::vector<std::vector<std::int32_t>> neighbors_by_cells(const Coordinates& points,
                                                                        double reach);

/// n points at random in the unit square or cube.
[[nodiscard]] Coordinates random_coordinates(int dimensions, std::size_t n);

}  // namespace vortree::bench
