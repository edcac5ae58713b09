#pragma once

#include <cstdint>
#include <vector>

#include "fmm/geometry/leaves.hpp"

namespace vortree::fmm {

/// Runs of childless cells, each the work of one thread, whatever the number of threads: inside a
/// run, near sums serve both sides at once; between runs, each computes its own.
class LeafRuns {
 public:
  LeafRuns() = default;
  explicit LeafRuns(const Leaves& leaves);

  [[nodiscard]] std::size_t size() const { return first_.empty() ? 0 : first_.size() - 1; }
  [[nodiscard]] tree::Range operator[](std::size_t leaf_run) const {
    return {first_[leaf_run], first_[leaf_run + 1]};
  }

 private:
  std::vector<std::uint32_t> first_;
};

}  // namespace vortree::fmm
