#include "fmm/slabs.hpp"

#include <algorithm>

namespace vortree::fmm {
namespace {

constexpr std::uint32_t slab_places = 16384;
constexpr std::uint32_t in_advance = 4;  // cells to ask memory for

/// `use(first)` for the blocks of a childless cell.
template <class Use>
void for_each_block(const Lists& lists, const Leaves& leaves, std::uint32_t cell, Use use) {
  const std::uint32_t leaf = lists.leaves(cell).first;
  for (std::uint32_t j = leaves.start[leaf]; j < leaves.start[leaf + 1]; j += lane_count) use(j);
}

void prefetch(const MutualPoints& points, std::uint32_t block) {
  for (const double* column : {points.x, points.y, points.gamma}) {
    __builtin_prefetch(column + block, 0, 2);
  }
  __builtin_prefetch(points.u + block, 1, 2);
  __builtin_prefetch(points.v + block, 1, 2);
}

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

void MutualNear::add(const DeepTree& tree, const Lists& lists, const Leaves& leaves,
                     tree::Range slab, double* u, double* v) {
  const MutualPoints points{leaves.points.x.data(), leaves.points.y.data(), leaves.gamma.data(), u,
                            v};
  const auto within = [&](std::uint32_t cell) {
    const std::uint32_t leaf = lists.leaves(cell).first;
    return leaf >= slab.first && leaf < slab.last;
  };
  for (std::uint32_t leaf = slab.first; leaf < slab.last; ++leaf) {
    const std::uint32_t own = tree.childless()[leaf];
    if (leaf + in_advance < slab.last) {
      lists.for_each_ahead(tree.childless()[leaf + in_advance], [&](std::uint32_t cell) {
        for_each_block(lists, leaves, cell, [&](std::uint32_t j) { prefetch(points, j); });
      });
    }
    inside_.clear(), outside_.clear();
    const auto gather = [&](std::uint32_t cell, std::vector<std::uint32_t>& blocks) {
      for_each_block(lists, leaves, cell, [&](std::uint32_t j) { blocks.push_back(j); });
    };
    lists.for_each_ahead(
        own, [&](std::uint32_t cell) { gather(cell, within(cell) ? inside_ : outside_); });
    lists.for_each_behind(own, [&](std::uint32_t cell) {
      if (!within(cell)) gather(cell, outside_);
    });
    const std::size_t room = padded(leaves.size[leaf]);
    if (u_.size() < room) u_.resize(room), v_.resize(room);
    const MutualCell cell{leaves.start[leaf], room, u_.data(), v_.data()};
    if (leaves.in_one_place(leaf)) {
      std::fill_n(cell.u, room, Lanes{});
      std::fill_n(cell.v, room, Lanes{});
    } else {
      meet_itself(points, cell);
    }
    meet_all<true>(points, cell, inside_);
    meet_all<false>(points, cell, outside_);
    close(points, cell);
  }
}

}  // namespace vortree::fmm
