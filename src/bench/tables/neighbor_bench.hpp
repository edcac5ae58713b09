#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>

namespace vortree::bench {

/// quick    smaller sets and less patience: two minutes instead of half an hour
/// threads  measured beside one thread; 0: as many as OpenMP takes
/// largest  no set has more particles; 0: about 4e6, quick 1e6
struct NeighborBench {
  std::filesystem::path csv;
  bool quick = false;
  int threads = 0;
  std::size_t largest = 0;
};

/// Measures every neighbor search on the sets of particle_sets.hpp: the paper's around a cylinder
/// (cases A to M of its table 1) and around an airfoil (table 3), the five-level cylinder scaled
/// from a thousand to four million particles, uniform ones of the same numbers.
///
/// csv      one row a measurement, written as soon as it is made; first lines that begin with #
///          say where the numbers come from and what the machine can do
///   family   levels (A, D to M), refined (A to C), foil, scaled, uniform
///   set, order, n, levels, method, rule, listing, threads
///   build, search, seconds, fastest   median times of `repeats` searches [s]; memory is warm
///   cpu      processor seconds a second during the repeats
///   pairs    entries of the list
///   bytes, list_bytes   memory that the first search added, and the list's part in it
///   write_share         of the time, what merely writing list_bytes to memory takes
/// A search that would take too long is left out. All lists of a set are compared: rows as sets.
/// At the end the exponents of n are fitted to the fastest times of the scaled and uniform sets.
///
/// say      told one line for each measurement
/// throws   std::runtime_error if the file cannot be written, or if two methods differ
void neighbor_bench(const NeighborBench& job, const std::function<void(std::string_view)>& say);

}  // namespace vortree::bench
