#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tree/neighbors/ball_search.hpp"
#include "tree/neighbors/pair_list.hpp"
#include "tree/neighbors/pair_rule.hpp"
#include "tree/neighbors/periodic_box.hpp"
#include "tree/order/points.hpp"

namespace vortree::tree {

/// Pairs that are near only across an edge of a periodic box. Added to the lists of the plane, by
/// whatever search, they make those of the box:
///
///   dx dx + dy dy < r r   holds for nearest images (periodic_box.hpp), not in the plane;
///
/// what holds in the plane does so in the box. Exact like the rule itself (pair_rule.hpp).
///
/// Each pair is sought by the particle of the wider reach, which under any rule is at least that of
/// the pair: only particles whose own reach goes over an edge look around, and only at those that
/// are no farther from an edge than the largest reach. Under rule own each looks for itself.
///
/// cost    O(n) for placing, with a tree of those near an edge (ball_search.hpp); a search in it
///         for each that looks around, and a copy of the list. Memory kept: some 60 bytes for each
///         near an edge
class CrossingPairs {
 public:
  /// reach   one for each point [m]
  /// throws  std::invalid_argument if sizes differ, as check_particles() does
  ///         (tree/cells/home_cells.hpp) and as check_inside() does
  CrossingPairs(Points points, std::span<const double> reach, const PeriodicBox& box);

  /// Adds them to lists of the same particles in the plane, behind what each row holds.
  ///
  /// rule, listing   of the lists; each pair once stands in the row of the wider reach or, of equal
  ///                 ones, of the smaller number
  /// throws          std::length_error if there are more than rows.most pairs together
  void add_to(PairRule rule, Listing listing, PairList& rows) const;

 private:
  struct Pair {
    std::int32_t i, j;
  };
  using Pairs = std::vector<Pair>;

  template <PairRule rule>
  void seek(std::uint32_t seeker, std::vector<std::int32_t>& near, Pairs& pairs) const;
  template <PairRule rule>
  [[nodiscard]] std::vector<Pairs> seek_all(const PairList& rows) const;

  PeriodicBox period_;
  std::vector<double> x_, y_, reach_;    // of those near an edge
  std::vector<std::int32_t> number_;     // their numbers
  std::vector<std::uint32_t> seekers_;   // which of them look around
  std::optional<BallSearch> near_edge_;  // none, if nobody looks around
};

/// Neighbors in a periodic box, in one call.
///
/// throws  as Neighbors::place and list, and as check_inside() does
[[nodiscard]] PairList neighbors(Points points, std::span<const double> reach,
                                 const PeriodicBox& box, PairRule rule,
                                 Listing listing = Listing::both_ways);

}  // namespace vortree::tree
