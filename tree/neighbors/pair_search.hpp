#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "tree/neighbors/candidate_kernel.hpp"
#include "tree/neighbors/pair_list.hpp"
#include "tree/neighbors/pair_rule.hpp"
#include "tree/neighbors/sorted_particles.hpp"
#include "tree/order/points.hpp"

namespace vortree::tree {

/// Particles that look for their neighbors together.
///
/// own      a run of placed particles
/// cell     what they lie in, for whoever names the candidates
/// length   about the size of the cell [m]
struct Group {
  Range own;
  std::uint32_t cell = 0;
  double length = 1;
};

/// Appends the runs of placed particles, besides its own ones, that hold every possible neighbor of
/// a group; for Listing::once only those that no other group names for the same pair.
using NameCandidates = std::function<void(const Group&, std::vector<Range>& others)>;

/// Lists of neighbors from groups and their candidates, however these were found: by QCG, by grids.
///
/// Every particle of a group is tested against all its candidates once. What passes is kept as
/// bits; when the length of each row is known, the rows are written where they belong. Groups are
/// shared among the threads; the rows do not depend on how.
///
/// cost    per particle, with k candidates for each: k/8 registers of floats, k/8 bytes until
///         the rows are written
class RowSearch {
 public:
  /// Lists into `rows`, whose old buffers are used again.
  ///
  /// groups   together hold every placed particle once
  /// throws   std::length_error if there are more pairs than rows.most
  void list(const SortedParticles& placed, std::span<const Group> groups,
            const NameCandidates& name, PairRule rule, Listing listing, PairList& rows);

  /// Shows every row that is not empty to a visitor; nothing is stored. What the visitor throws
  /// comes out.
  void visit(const SortedParticles& placed, std::span<const Group> groups,
             const NameCandidates& name, PairRule rule, Listing listing, const RowVisitor& visitor);

  /// Memory that is kept for the next list [bytes].
  [[nodiscard]] std::size_t bytes() const;

 private:
  // Groups that one thread takes at a time, and what it found. Not in the cache lines of another.
  struct alignas(128) Chunk {
    std::size_t first, last;  // groups
    std::vector<Range> others;
    std::vector<std::uint32_t> other_count;  // of each group
    Unwritten<kernel::Hits> kept, hits;
  };
  class Pass;

  void share_out(std::span<const Group> groups);

  std::vector<Chunk> chunks_;
};

}  // namespace vortree::tree
