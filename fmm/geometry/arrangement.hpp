#pragma once

#include <cstdint>
#include <span>

#include "fmm/geometry/cells.hpp"
#include "fmm/geometry/units.hpp"
#include "fmm/sources.hpp"
#include "tree/base/memory.hpp"
#include "tree/build/quadtree.hpp"
#include "tree/build/split_rule.hpp"

namespace vortree::fmm {

/// Which walk builds the tree; both build the same.
enum class Builder { reverse, forward };

[[nodiscard]] tree::Quadtree build(tree::MortonOrder order, const tree::SplitRule& rule,
                                   Builder builder);

/// Points put in order for a sum: their tree, their values in its order and in Units, and the
/// shapes of its cells.
struct Arrangement {
  tree::Quadtree tree;
  SortedPoints points;
  CellShapes shapes;
};

/// How a tree is grown: cells of more than `capacity` points split, down to `finest_level`.
struct TreeOptions {
  std::uint32_t capacity;
  int finest_level = tree::max_level;
  Builder builder = Builder::reverse;
};

[[nodiscard]] Arrangement arrange(const Targets& points, const Units& units,
                                  const TreeOptions& growth);

/// Circulations in the order of the tree, in Units.
[[nodiscard]] Reals arrange_gamma(const tree::Quadtree& tree, std::span<const double> gamma,
                                  const Units& units);

}  // namespace vortree::fmm
