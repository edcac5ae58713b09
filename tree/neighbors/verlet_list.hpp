#pragma once

#include <span>
#include <vector>

#include "tree/neighbors/neighbors.hpp"

namespace vortree::tree {

/// Lists that last for several steps: pairs are sought with every reach a little longer, by a skin,
/// and hold all neighbors until some particle has moved half of its skin.
///
///   listed:   |x_i - x_j| < pair_reach((1 + skin) r_i, (1 + skin) r_j)   when it was built
///   valid:    each particle k has moved at most skin r_k / 2 since, less what rounding may make of
///             lengths; under rule own, at most skin min_k r_k / 2: there a fine particle looks at
///             coarse ones that move far
///
/// A step that splits or merges particles, or makes any reach longer, needs a new list.
///
/// source  Verlet, Phys. Rev. 159 (1967)
class VerletList {
 public:
  /// throws  std::invalid_argument if skin is negative or not finite
  VerletList(PairRule rule, Listing listing, double skin);

  /// Must the list be built anew for particles that are there now? True before the first.
  ///
  /// cost    O(n)
  /// throws  std::invalid_argument if sizes differ
  [[nodiscard]] bool outdated(Points points, std::span<const double> reach) const;

  /// Builds the list; errors as of Neighbors::place and list.
  void rebuild(Points points, std::span<const double> reach);

  /// Every neighbor, and some more that are within the skin.
  [[nodiscard]] const PairList& candidates() const { return rows_; }

  /// Only those that are neighbors now, for particles for which the list is not outdated.
  void narrow(Points points, std::span<const double> reach, PairList& rows) const;

 private:
  PairRule rule_;
  Listing listing_;
  double skin_;
  bool built_ = false;
  std::vector<double> x_, y_, reach_, wide_;  // where particles were; their reaches, with skin
  Neighbors search_;
  PairList rows_;
};

}  // namespace vortree::tree
