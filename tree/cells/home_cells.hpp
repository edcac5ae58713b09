#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tree/base/memory.hpp"
#include "tree/build/quadtree.hpp"
#include "tree/neighbors/sorted_particles.hpp"

namespace vortree::tree {

/// The occupied own cells of some particles. The own cell of a particle is that of the deepest
/// level, at most 29, whose side still spans its reach:
///
///   level(i) = max { l : side / 2^l >= (1 + 2^-18) r_i }, 0 if there is none
///
/// Cells stand in Morton order of their lower left corners; on one corner the coarse before the
/// fine. So a cell comes before all cells inside it, and those follow at once.
///
/// corner    level-31 code of the corner of every cell
/// level     of every cell
/// first     where the particles of every cell begin, and the end of the last
struct HomeCells {
  Domain domain;
  Unwritten<MortonKey> corner;
  std::vector<std::int16_t> level;
  std::vector<std::uint32_t> first;

  [[nodiscard]] std::size_t size() const { return corner.size(); }

  /// The tree whose points are these cells, each at its corner: a block must split if a finer own
  /// cell than itself is inside and more than `few` particles are. That is rule roomy, and costs
  /// O(1) a question: the last own cell of a block is a finer one, if there is any.
  [[nodiscard]] Quadtree tree(std::uint32_t few) const;
};

/// Refuses particles that no list can be made of.
///
/// cost     O(n)
/// throws   std::invalid_argument naming the first coordinate that is not finite or exceeds
///          largest_coordinate, or the first reach that is negative or not finite
void check_particles(Points points, std::span<const double> reach);

/// Sorts particles by their own cells, in a domain so much larger than the points that the cells of
/// some level are as wide as the largest reach: where reaches are halved from level to level,
/// particles fill their cells.
///
/// reach    one for each point [m]
/// placed   the particles cell by cell, those of a cell in input order; overwritten
/// cost     O(n), a radix sort; 16 bytes a particle beyond what is returned (where sides of the
///          domain and of the smallest cell are 2^20 and more apart, 28)
/// throws   as check_particles
[[nodiscard]] HomeCells sort_into_own_cells(Points points, std::span<const double> reach,
                                            SortedParticles& placed);

/// The same with the cells of a tree of the points: a particle's own cell is no finer than the
/// childless cell that holds it.
[[nodiscard]] HomeCells sort_into_own_cells(const Quadtree& tree, Points points,
                                            std::span<const double> reach, SortedParticles& placed);

}  // namespace vortree::tree
