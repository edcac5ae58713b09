#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tree/neighbors/pair_list.hpp"
#include "tree/neighbors/pair_rule.hpp"
#include "tree/neighbors/periodic_box.hpp"

namespace vortree::app {

/// Every method by which `vortree neighbors` can search, best first.
std::vector<std::string> neighbor_methods();

/// in     a word of io::read_particles
/// reach  of all particles, whatever their file says
/// box    whose nearest images are asked for, by any method; none: the plane
/// said   the command line, for the output to tell
struct NeighborsJob {
  std::filesystem::path in, out;
  std::optional<double> reach;
  std::string said;
  std::string method = "qcg";
  tree::PairRule rule = tree::PairRule::max;
  tree::PeriodicBox box;
  bool half = false;  // each pair once
  int repeat = 1;
};

/// Neighbors of all particles of a file: reads x, y and reach, searches `repeat` times, writes the
/// compressed rows `start` (n + 1, int64) and `index` (int32), particles in input order; into a
/// .csv a line for each entry: the particle `i` and its neighbor `j`, counted from 0.
///
/// returns  what was done, as JSON on one line, for standard output: n, method, builder, threads,
///          rule, half, periodic (both lengths, of a box), pairs (as many as index has),
///          peak_bytes, seconds {tree, search, total: medians of all repetitions; io}. The builder
///          of a method that has no tree is null.
/// throws   io::InputError for wrong files, std::invalid_argument for each pair once under rule
///          own, std::runtime_error for more particles or pairs than the free memory holds
std::string neighbors(const NeighborsJob& job);

}  // namespace vortree::app
