#include "fmm/lists/leaf_runs.hpp"

#include <algorithm>

#include "fmm/tuning.hpp"

namespace vortree::fmm {
namespace {

std::uint32_t places_of_run(const Leaves& leaves) {
  const auto share = static_cast<std::uint32_t>(leaves.places() / leaf_runs);
  return leaves.cored() ? std::clamp(share, shortest_leaf_run, longest_leaf_run) : longest_leaf_run;
}

}  // namespace

LeafRuns::LeafRuns(const Leaves& leaves) {
  const std::uint32_t size = places_of_run(leaves);
  std::uint32_t begun = 0;
  for (std::uint32_t leaf = 0; leaf < leaves.count(); ++leaf) {
    if (leaf == 0 || leaves.start[leaf] >= begun + size) {
      first_.push_back(leaf);
      begun = leaves.start[leaf];
    }
  }
  first_.push_back(static_cast<std::uint32_t>(leaves.count()));
}

}  // namespace vortree::fmm
