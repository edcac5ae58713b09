#pragma once

#include <cstdint>
#include <vector>

#include "fmm/leaves.hpp"
#include "fmm/lists.hpp"
#include "fmm/mutual_kernel.hpp"

namespace vortree::fmm {

/// Runs of childless cells, each the work of one thread, whatever the number of threads: inside a
/// run, near sums serve both sides at once; between runs, each computes its own.
class Slabs {
 public:
  Slabs() = default;
  explicit Slabs(const Leaves& leaves);

  [[nodiscard]] std::size_t size() const { return first_.empty() ? 0 : first_.size() - 1; }
  [[nodiscard]] tree::Range operator[](std::size_t slab) const {
    return {first_[slab], first_[slab + 1]};
  }

 private:
  std::vector<std::uint32_t> first_;
};

/// Near sums of bare vortices in a slab of childless cells.
class MutualNear {
 public:
  /// Adds to u and v (times 2 pi, in the places of leaves) all pairs of U with a target in the
  /// slab.
  void add(const DeepTree& tree, const Lists& lists, const Leaves& leaves, tree::Range slab,
           double* u, double* v);

 private:
  std::vector<std::uint32_t> inside_, outside_;  // first places of blocks
  Unwritten<Lanes> u_, v_;
};

}  // namespace vortree::fmm
