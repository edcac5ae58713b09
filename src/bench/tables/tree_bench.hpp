#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/sets/point_sets.hpp"

namespace vortree::bench {

struct NamedSet {
  std::string name;
  PointSet set;
};

/// folder   for trees.csv and trees_reuse.csv
/// quick    two minutes instead of fifteen
/// threads  measured beside one thread; 0: as many as OpenMP takes
/// largest  no made set has more points; 0: 1e7, quick 1e6
/// flows    blobs of a flow at some times, measured beside the made sets
struct TreeBench {
  std::filesystem::path folder;
  bool quick = false;
  int threads = 0;
  std::size_t largest = 0;
  std::vector<NamedSet> flows;
};

/// Measures every way from unsorted points to a tree, and what a velocity evaluation costs with it.
///
/// partition     forward, particles moved level by level (forward_by_partition)
/// forward       forward on sorted codes (tree::build_forward)
/// printed       reverse level by level from level 31 (reverse_as_printed); printed_known from the
///               deepest level that the tree has, as if that were known
/// climb         reverse, families climbing, any rule (tree::build_reverse, the rule unknown to it)
/// reverse       reverse in one pass (tree::build_reverse)
///
/// trees.csv, one row a measurement, after lines that begin with # as in velocity.csv:
///   set, n, n_ctrl, builder, threads
///   ready, fastest      from points to tree: median and least of `repeats` [s], memory warm; the
///                       medians of its parts: enclose, encode, sort, build and, where points in a
///                       childless cell are ordered for the sake of equality alone, finish
///   cells, childless, depth
///   kept, peak          bytes of the tree, and that the process grew by at most on the way
///   floor               least seconds to read the points and to write codes and indices: 28 bytes
///   a
///                       point through memory
///   velocity            seconds of a whole evaluation, Plan at 1e-6 with this n_ctrl, its tree
///                       part taken from this builder, without finish; empty where not measured
///   lists               what else the Plan's phase "tree" does: order of the blobs, lists
/// trees_reuse.csv:
///   set, n, stored (in order, or random), step (of every coordinate, standard deviation in mean
///   spacings), threads, scratch, repaired: seconds of morton_order and of repaired_order
/// say      told one line for each measurement
/// throws   std::runtime_error if a file cannot be written
void tree_bench(const TreeBench& job, const std::function<void(std::string_view)>& say);

}  // namespace vortree::bench
