#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/sets/point_sets.hpp"
#include "tree/order/points.hpp"

/// The measurements behind tree_bench.
namespace vortree::bench {

/// Laps go on for so many seconds or so often, but seven times at least.
struct LapLimit {
  double seconds;
  int most;
  [[nodiscard]] bool more(const std::vector<double>& laps) const;
};

/// Ways from points to a tree, worst first.
inline constexpr std::string_view tree_builders[] = {"partition",     "forward", "printed",
                                                     "printed_known", "climb",   "reverse"};

/// What one way needed: medians [s], by part ("enclose", "encode", "sort", "build", "finish"), and
/// bytes.
struct TreeMade {
  double ready = 0.0, fastest = 0.0;
  std::map<std::string, double> parts;
  std::size_t repeats = 0, kept = 0, cells = 0, childless = 0;
  int depth = 0;
  std::optional<std::size_t> peak;
};

/// Runs all ways, by turns: what disturbs the machine disturbs all.
///
/// domain   empty: found anew each time, as a part of the work
std::map<std::string_view, TreeMade> tree_contest(tree::Points points,
                                                  const std::optional<tree::Domain>& domain,
                                                  std::uint32_t n_ctrl, const LapLimit& limit);

/// A Plan's evaluation: all of it and its phase "tree" [s], and where that grows its tree.
struct Evaluation {
  double all = 0.0, tree = 0.0;
  tree::Domain domain;
};
Evaluation evaluate(const PointSet& set, double tolerance, std::uint32_t n_ctrl,
                    const LapLimit& limit);

}  // namespace vortree::bench
