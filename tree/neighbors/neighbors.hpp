#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tree/build/colleagues.hpp"
#include "tree/build/quadtree.hpp"
#include "tree/cells/home_cells.hpp"
#include "tree/neighbors/pair_list.hpp"
#include "tree/neighbors/pair_rule.hpp"
#include "tree/neighbors/pair_search.hpp"
#include "tree/neighbors/sorted_particles.hpp"

namespace vortree::tree {

/// Neighbors of particles of many sizes: Quadtree Cells Grid.
///
/// Every particle is placed in its own cell (home_cells.hpp), the deepest whose side still spans
/// its reach (or the childless cell that holds it, if that is coarser): coarse particles stay in
/// cells that are split for the sake of finer ones, so that there are particles in cells of every
/// level. The tree is one of own cells, each a point at its corner: of a block is asked whether
/// half its side still spans the smallest reach inside, unless no more than a handful are there.
///
/// Particles are sorted cell by cell, those of a cell before those of its descendants, so that a
/// cell with everything finer in it is one range, and so is what is its own. Then
///
/// - every partner of a particle that is as fine or finer lies in the 3 x 3 cells of its own level:
///   nine ranges. Where one of the nine is missing from the tree there are only coarser particles;
/// - the coarser ones are the cell's ancestors' and their colleagues' own, level by level. For each
///   pair once they need not be sought: the coarser particle of the pair finds it.
///
/// All particles of a cell share their candidates. Lists hold exactly the pairs for which
/// tree/neighbors/pair_rule.hpp says so. Threads share the work; lists do not depend on their
/// number.
///
/// Any reach will do: from zero to far beyond the domain, continuous or halved from level to level.
/// So will any cloud: where 29 levels do not tell particles apart (clusters far smaller than the
/// whole, an outlier far away), cells go on below (deep_cells.hpp).
///
/// cost    O(n) for placing; for each particle its candidates, some three for each neighbor. Memory
///         kept: 28 bytes a particle, 50 a cell, 24 a group, a bit or two a candidate; while
///         particles are sorted 32 more, 40 where cells go on below
/// source  Khorasanizade & Sousa 2019, Quadtree Cells Grid, corrected: pairs are sought from the
///         coarser side, where neighbors two or more levels apart are not missed; each once;
///         cells come from the tree, so none stays split when its fine particles have gone, and no
///         particle is outside
class Neighbors {
 public:
  /// Places particles in a tree of their own, some level of which has cells as wide as the largest
  /// reach.
  ///
  /// reach   one for each point [m]
  /// throws  std::invalid_argument if sizes differ, if there are 2^31 points or more, or naming the
  ///         first coordinate that is not finite or exceeds largest_coordinate (points.hpp), or the
  ///         first reach that is negative or not finite
  void place(Points points, std::span<const double> reach);

  /// Places particles no deeper than in a given tree, which is no longer needed afterwards.
  ///
  /// tree    of these points; lists do not depend on it, time does
  /// reach   one for each point [m]
  /// throws  std::invalid_argument if sizes differ, if there are 2^31 points or more, or naming the
  ///         first reach that is negative or not finite
  void place(const Quadtree& tree, Points points, std::span<const double> reach);

  /// Lists the neighbors of all placed particles.
  ///
  /// rows    overwritten; its buffers are used again
  /// throws  std::invalid_argument for each pair once under rule own, which is not symmetric;
  ///         std::length_error if there are more pairs than rows.most
  void list(PairRule rule, Listing listing, PairList& rows);

  /// Shows every particle that has neighbors, with them, to a visitor; no list is stored.
  void visit(PairRule rule, Listing listing, const RowVisitor& visitor);

  /// How many candidates all particles have together: so many tests a list may cost at most, most
  /// of them spared as a group thins out its candidates first.
  [[nodiscard]] std::uint64_t candidates(Listing listing) const;

  /// The particles in search order.
  [[nodiscard]] const SortedParticles& placed() const { return placed_; }

  /// Memory kept for the next time [bytes].
  [[nodiscard]] std::size_t bytes() const;

 private:
  // Placed particles of a cell: its own [first, finer), those of its descendants [finer, last).
  struct Content {
    std::uint32_t first, finer, last;
  };

  void settle(const HomeCells& own);
  void find_content(std::span<const Cell> cells, std::span<const std::int16_t> level,
                    std::span<const std::uint32_t> particles);
  void find_coarser(std::span<const Cell> cells);
  void make_groups(std::span<const Cell> cells, std::span<const double> sides);
  void name_candidates(const Group& group, Listing listing, std::vector<Range>& others) const;

  SortedParticles placed_;
  std::vector<Content> content_;        // of each cell
  std::vector<Colleagues> colleagues_;  // of each cell
  std::vector<std::int32_t> coarser_;   // next ancestor with particles of its own nearby; -1: none
  std::vector<Group> groups_;
  RowSearch search_;
};

/// The same in one call.
[[nodiscard]] PairList neighbors(Points points, std::span<const double> reach, PairRule rule,
                                 Listing listing = Listing::both_ways);

}  // namespace vortree::tree
