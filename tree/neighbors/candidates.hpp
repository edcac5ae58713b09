#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tree/base/buffer.hpp"
#include "tree/neighbors/candidate_kernel.hpp"
#include "tree/neighbors/pair_rule.hpp"
#include "tree/neighbors/sorted_particles.hpp"
#include "tree/order/points.hpp"

namespace vortree::tree {

/// The particles of one cell and all candidates for their neighbors, side by side: first the
/// particles themselves, then whoever of the given ranges is near enough to their bounding box.
/// Looked up and thinned out once, tested by every particle of the cell.
///
/// Positions are floats, relative to the middle of the box, in units of about the cell's side: what
/// a test in floats leaves in doubt is decided in doubles (candidate_kernel.hpp).
class Candidates {
 public:
  /// own      the particles of the cell; not empty
  /// others   ranges without them
  /// length   a unit for the floats, about the size of the cell [m]
  template <PairRule rule>
  void gather(const SortedParticles& placed, Range own, std::span<const Range> others,
              double length);

  /// Registers full of candidates.
  [[nodiscard]] std::size_t registers() const { return registers_; }

  /// Tests own particle `local` against the registers from `first` on; a set of lanes for each goes
  /// to hits[0], ... Returns how many passed; the particle itself is among them if it has a reach.
  template <PairRule rule>
  std::int64_t test(std::size_t local, std::size_t first, kernel::Hits* hits);

  /// Who of each register of the ranges was kept, range by range.
  [[nodiscard]] std::span<const kernel::Hits> kept() const { return kept_; }

 private:
  struct Frame {
    double x, y, scale;
    float half_u, half_v, largest;  // largest: reach of the own ones
    bool quiet;                     // all of them are zero
  };
  [[nodiscard]] static Frame frame(const SortedParticles& placed, Range own, double length);
  template <PairRule rule>
  void add_own(const SortedParticles& placed, Range own, const Frame& frame);
  template <PairRule rule, bool quiet>
  void add(const SortedParticles& placed, Range others, const Frame& frame);
  void close();
  void find_positions();

  const SortedParticles* placed_ = nullptr;
  Range own_;
  std::vector<Range> others_;
  Buffer<float> u_, v_, reach_;
  std::vector<kernel::Hits> kept_;
  std::size_t size_ = 0, registers_ = 0;
  float h2_ = 0, farthest_ = 0;
  std::vector<std::int32_t> position_;  // of each candidate among the placed; found when in doubt
};

/// Those of the numbers `of` that the ranges of a block hold, in the block's order: own ones first,
/// then those kept of each range.
///
/// kept     as Candidates::kept says; the sets that were used are returned
/// to       room for all numbers of the ranges, and a register more
/// count    set to how many there are
std::size_t gather_numbers(const Buffer<std::int32_t>& of, Range own, std::span<const Range> others,
                           const kernel::Hits* kept, std::int32_t* to, std::size_t& count);

}  // namespace vortree::tree
