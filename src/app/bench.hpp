#pragma once

#include <cstddef>
#include <filesystem>

namespace vortree::app {

struct BenchJob {
  std::filesystem::path out;  // empty: runs/bench_WHAT
  bool quick = false;
  int threads = 0;          // measured beside one thread; 0: all
  std::size_t largest = 0;  // most blobs or particles of a set; 0: as the bench says
};

/// Measures the velocity methods, a line each on standard output; leaves velocity.csv and its
/// figures in a folder.
///
/// throws  io::InputError if the folder cannot be written to
void bench_velocity(const BenchJob& job);

/// The same for the neighbor searches: neighbors.csv.
void bench_neighbors(const BenchJob& job);

}  // namespace vortree::app
