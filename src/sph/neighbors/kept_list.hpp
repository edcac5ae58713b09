#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "tree/neighbors/pair_list.hpp"
#include "tree/order/points.hpp"

namespace vortree::sph {

/// A list of pairs under the rule mean that outlives steps in which particles move, change their
/// reaches and numbers, come and go. Each particle has an anchor, a place and a wider reach,
///
///   listed:   |X_i - X_j| < (R_i + R_j)/2,      R = (1 + skin) r when the anchor was laid
///   valid:    r_k + 2 |x_k - X_k| <= R_k        for every particle k, less what rounding may make
///
/// so that by the triangle inequality no neighbor is missing. A particle that breaks this, or that
/// is new, gets a new anchor, and is held against all others; where these are many, all do.
///
/// Rows are in the order of numbers: what is found does not depend on how old the list is.
///
/// source  Verlet, Phys. Rev. 159 (1967), 98; anchors of their own age are ours
class KeptList {
 public:
  /// Lists the pairs of points by reaches; rows in the order of numbers.
  using Search =
      std::function<void(tree::Points points, std::span<const double> reach, tree::PairList& rows)>;

  /// The neighbors of particles that are there now.
  ///
  /// was     the number of each particle when it was last listed; -1: it was not. What is wrong
  ///         costs time, but no neighbor: an anchor that is far away is not valid
  /// skin    in reaches
  /// search  by which all are listed where too little can be kept
  void renew(tree::Points points, std::span<const double> reach, std::span<const std::int32_t> was,
             double skin, const Search& search, tree::PairList& rows);

  /// Lists that were made anew so far, and particles that were sought alone.
  [[nodiscard]] long rebuilt() const { return rebuilt_; }
  [[nodiscard]] long sought() const { return sought_; }

 private:
  void find_anchors(tree::Points points, std::span<const double> reach,
                    std::span<const std::int32_t> was);
  void rebuild(tree::Points points, std::span<const double> reach, double skin,
               const Search& search);
  void lay_anchors(tree::Points points, std::span<const double> reach, double skin);
  void seek();
  void renumber();
  void narrow(tree::Points points, std::span<const double> reach, tree::PairList& rows) const;

  [[nodiscard]] bool same_numbers() const;

  tree::PairList list_, next_;
  std::vector<double> x_, y_, reach_;    // anchors
  std::vector<std::int32_t> from_, to_;  // numbers of now in the list, and the other way; -1: none
  std::vector<std::int32_t> without_;    // particles of now without a valid anchor
  struct SoughtPair {
    std::int32_t of, neighbor;
    auto operator<=>(const SoughtPair&) const = default;
  };
  std::vector<SoughtPair> found_;
  long rebuilt_ = 0, sought_ = 0;
};

}  // namespace vortree::sph
