#include "fmm/lists/leaf_runs.hpp"

#include <algorithm>

namespace vortree::fmm {
namespace {

/// Enough runs of leaves for some threads where sums with cores make even few points worth sharing;
/// not so many that what lies along their borders, summed on both sides, costs a tenth more.
std::uint32_t places_of_slab(const Leaves& leaves) {
  constexpr std::uint32_t least = 1024, most = 16384;
  const auto eighth = static_cast<std::uint32_t>(leaves.places() / 8);
  return leaves.cored() ? std::clamp(eighth, least, most) : most;
}

}  // namespace

LeafRuns::LeafRuns(const Leaves& leaves) {
  const std::uint32_t size = places_of_slab(leaves);
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
