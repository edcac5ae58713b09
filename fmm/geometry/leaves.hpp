#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fmm/geometry/cells.hpp"
#include "fmm/geometry/deep_tree.hpp"
#include "fmm/geometry/vortices.hpp"
#include "tree/base/memory.hpp"

namespace vortree::fmm {

/// The points of the childless cells in whole vectors: those of a cell begin at a multiple of
/// their lanes and are filled up with copies of the last one without circulation. In Units.
///
/// start   of every childless cell by rank, and the end of all
struct Leaves {
  SortedPoints points;  // core is empty if all are bare
  Reals gamma;
  std::vector<std::uint32_t> start, size;

  Leaves() = default;
  /// vortices   in input order
  /// cored      false: their cores do not count
  /// whole      lanes of a vector; those of bare points only, blobs are in vectors of doubles
  Leaves(const DeepTree& tree, std::span<const Vortex> vortices, bool cored, std::size_t whole);

  [[nodiscard]] bool cored() const { return !points.core.empty(); }
  [[nodiscard]] std::size_t count() const { return size.size(); }
  [[nodiscard]] std::size_t places() const { return start.empty() ? 0 : start.back(); }
  /// True for a crowd of points that do nothing to each other. Small cells are not looked at.
  [[nodiscard]] bool in_one_place(std::uint32_t leaf) const;

  /// The places of some childless cells, by rank.
  [[nodiscard]] tree::Range places(tree::Range leaves) const {
    return {start[leaves.first], start[leaves.last]};
  }
  [[nodiscard]] std::size_t bytes() const {
    return sizeof(double) * (gamma.capacity() * 3 + points.core.capacity()) +
           sizeof(std::uint32_t) * (start.capacity() + size.capacity());
  }

 private:
  void number(const DeepTree& tree, std::size_t whole);
};

}  // namespace vortree::fmm
