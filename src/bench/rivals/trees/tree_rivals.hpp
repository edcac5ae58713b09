#pragma once

#include <cstdint>
#include <span>

#include "tree/base/phase.hpp"
#include "tree/build/quadtree.hpp"

/// Ways to a tree that lose, or that the literature knows: what the builders of tree/ are held
/// against. All end in the tree that those build.
namespace vortree::bench {

/// From root to leaf without sorting first: level by level, the particles of every crowded cell are
/// moved to its four quarters. As the quadtree scheme does that the reverse one is meant to better.
///
/// phase    "encode": the level-31 codes, of which two bits are looked at on each level, so that no
///          rounding can tell the trees apart; "build"; and "finish": the order of the particles
///          inside a childless cell, which a sum does not need, but equal trees do
/// threads  share the cells of a level
[[nodiscard]] tree::Quadtree forward_by_partition(tree::Points points, const tree::Domain& domain,
                                                  std::uint32_t n_ctrl, const tree::Phase& phase);

/// From leaf to root as printed: at every level, from `start` up to the root, families of four are
/// looked at that come one after the other among the occupied cells, and are merged if they hold no
/// more than n_ctrl particles in total. Childless cells are recorded as they stop merging.
///
/// start    the tree must not be deeper; the finest level if nothing is known
/// source   Huang, Huang, Xu & Hu, Thermal Science 16 (2012), steps 6-8
[[nodiscard]] tree::Quadtree reverse_as_printed(tree::MortonOrder order, std::uint32_t n_ctrl,
                                                int start);

/// The order of the same points a step earlier, repaired: encoded in that order, cut into blocks;
/// who belongs to another block moves there, and every block is sorted unless it is in order. What
/// morton_order gives.
[[nodiscard]] tree::MortonOrder repaired_order(tree::Points points, const tree::Domain& domain,
                                               std::span<const std::uint32_t> previous);

}  // namespace vortree::bench
