#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace vortree::app {

struct BenchJob {
  std::filesystem::path out;  // empty: runs/bench_WHAT
  bool quick = false;
  bool overwrite = false;       // older tables in `out` may be replaced
  int threads = 0;              // measured beside one thread; 0: all
  std::size_t largest = 0;      // most blobs or particles of a set; 0: as the bench says
  std::filesystem::path blobs;  // trees: a frames file of which some moments are measured, too
  std::vector<std::filesystem::path> runs;  // step: folders of runs that are measured instead
};

/// Measures the velocity methods, a line each on standard output; leaves velocity.csv and its
/// figures in a folder.
///
/// throws  io::InputError if the folder cannot be written to, or holds such tables already
void bench_velocity(const BenchJob& job);

/// Measures the ways to a tree, a line each on standard output; leaves trees.csv, trees_reuse.csv
/// and their figures in a folder.
///
/// throws  io::InputError if the folder cannot be written to or the frames file cannot be read
void bench_trees(const BenchJob& job);

/// The same for the neighbor searches: neighbors.csv.
void bench_neighbors(const BenchJob& job);

/// The same for steps of flows: step.csv.
///
/// throws  io::InputError, too, for folders that hold no runs by vortices
void bench_step(const BenchJob& job);

}  // namespace vortree::app
