#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tree/base/buffer.hpp"
#include "tree/neighbors/candidate_kernel.hpp"
#include "tree/neighbors/pair_list.hpp"
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
  /// others   ranges without them; they and `kept` stay where they are until all are tested
  /// length   a unit for the floats, about the size of the cell [m]
  /// kept     who of each register of the ranges was kept is appended, range by range
  template <PairRule rule>
  void gather(const SortedParticles& placed, Range own, std::span<const Range> others,
              double length, Unwritten<kernel::Hits>& kept);

  /// Registers full of candidates.
  [[nodiscard]] std::size_t registers() const { return registers_; }

  /// Where the candidates of an own particle begin: each pair once means with those behind it.
  [[nodiscard]] static std::size_t first_register(std::size_t local, Listing listing) {
    return listing == Listing::once ? local / single_count : 0;
  }

  /// Own particles that are tested together: each candidate is loaded once for them.
  static constexpr std::size_t at_once = 2;

  /// Tests own particles first..last - 1, each against all registers from first_register on. Sets
  /// of lanes go to hits[0], ..., particle by particle, and how many passed to found[0], ... A
  /// particle is no hit of itself nor, for each pair once, who is before it.
  ///
  /// first     a multiple of at_once
  /// returns   the end of the sets
  template <PairRule rule>
  kernel::Hits* test(std::size_t first, std::size_t last, Listing listing, kernel::Hits* hits,
                     std::int64_t* found);

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
  void add(const SortedParticles& placed, std::span<const Range> others, const Frame& frame,
           kernel::Hits* kept);
  void close();
  void find_positions();
  std::int64_t test_exactly(PairRule rule, std::size_t local, std::size_t first,
                            kernel::Hits* hits);

  const SortedParticles* placed_ = nullptr;
  Range own_;
  std::span<const Range> others_;
  const kernel::Hits* kept_ = nullptr;
  Buffer<float> u_, v_, reach_;
  std::size_t size_ = 0, registers_ = 0;
  float h2_ = 0;
  bool in_floats_ = false;              // no square of theirs overflows
  std::vector<std::int32_t> position_;  // of each candidate among the placed; found when in doubt
};

/// Those of the numbers `of` that the ranges of a block hold, in the block's order: own ones first,
/// then those kept of each range.
///
/// kept     as of Candidates::gather; the sets that were used are returned
/// to       room for all numbers of the ranges, and a register more
/// count    set to how many there are
std::size_t gather_numbers(const Buffer<std::int32_t>& of, Range own, std::span<const Range> others,
                           const kernel::Hits* kept, std::int32_t* to, std::size_t& count);

}  // namespace vortree::tree
