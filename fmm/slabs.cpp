#include "fmm/slabs.hpp"

namespace vortree::fmm {
namespace {

constexpr std::uint32_t slab_places = 16384;

}  // namespace

Slabs::Slabs(const Leaves& leaves) {
  std::uint32_t begun = 0;
  for (std::uint32_t leaf = 0; leaf < leaves.count(); ++leaf) {
    if (leaf == 0 || leaves.start[leaf] >= begun + slab_places) {
      first_.push_back(leaf);
      begun = leaves.start[leaf];
    }
  }
  first_.push_back(static_cast<std::uint32_t>(leaves.count()));
}

}  // namespace vortree::fmm
