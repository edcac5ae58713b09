#include "fmm/boxes/evaluate.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "fmm/boxes/batch.hpp"
#include "fmm/boxes/far.hpp"
#include "fmm/near/near.hpp"
#include "fmm/tuning.hpp"
#include "tree/base/parallel.hpp"

namespace vortree::fmm {
namespace {

/// What a thread needs for one block, kept for the next one.
struct Scratch {
  SharedInteractions shared;
  Interactions found;
  FarSums far;
  NearSources near;
  Batch block, leaf;
};

/// A cell of the target tree with no more than targets_a_block targets, or childless; its leaves.
struct BlockOfLeaves {
  std::uint32_t cell, first, last;
};

std::vector<BlockOfLeaves> gather_blocks(const tree::Quadtree& tree) {
  const auto cells = tree.cells();
  const auto leaves = tree.childless();
  std::vector<BlockOfLeaves> blocks;
  for (std::uint32_t k = 0; k < leaves.size(); ++k) {
    std::uint32_t c = leaves[k];
    while (cells[c].parent >= 0 && cells[cells[c].parent].points.size() <= targets_a_block) {
      c = static_cast<std::uint32_t>(cells[c].parent);
    }
    if (blocks.empty() || blocks.back().cell != c) blocks.push_back({c, k, k});
    blocks.back().last = k + 1;
  }
  return blocks;
}

/// What it is expected to lose at a target.
template <class Pair>
Lost evaluate_leaf(const ArrangedSources& sources, const Arrangement& targets, std::uint32_t leaf,
                   const Acceptance& acceptance, bool coarse, Scratch& scratch) {
  const tree::Range range = targets.tree.cells()[leaf].points;
  const TargetBox target = box(targets.shapes, leaf);
  find_interactions(sources.at.tree, sources.at.shapes, target, acceptance, scratch.shared.waiting,
                    scratch.found);
  Batch& batch = scratch.leaf;
  batch.take(targets.points, range, target);
  scratch.far.add(sources.at.shapes, sources.multipoles, scratch.found.series, batch);
  scratch.near.pack(sources.at.points, sources.gamma, target, acceptance, scratch.found);
  scratch.near.sum<Pair>(target,
                         {batch.x.data(), batch.y.data(), batch.core.data(), batch.u.data(),
                          batch.v.data(), range.size()},
                         coarse);
  Lost lost = lost_by_series(sources.multipoles, acceptance, scratch.found.series, 0);
  lost += scratch.near.lost(acceptance.reach2, 0, coarse);
  return lost;
}

template <class Pair>
Expected evaluate_block(const ArrangedSources& sources, const Arrangement& targets,
                        const BlockOfLeaves& block, const Acceptance& acceptance, bool coarse,
                        Scratch& scratch, std::span<double> u, std::span<double> v) {
  const auto cells = targets.tree.cells();
  const auto order = targets.tree.order();
  const tree::Range all = cells[block.cell].points;
  const TargetBox around = box(targets.shapes, block.cell);
  find_shared(sources.at.tree, sources.at.shapes, around, acceptance, scratch.shared);
  scratch.block.take(targets.points, all, around);
  scratch.far.add(sources.at.shapes, sources.multipoles, scratch.shared.series, scratch.block);
  Expected expected{0.0,
                    static_cast<double>(all.size()) *
                        lost_by_series(sources.multipoles, acceptance, scratch.shared.series, 0)};
  for (std::uint32_t k = block.first; k < block.last; ++k) {
    const std::uint32_t leaf = targets.tree.childless()[k];
    const Lost lost = evaluate_leaf<Pair>(sources, targets, leaf, acceptance, coarse, scratch);
    const tree::Range own = cells[leaf].points;
    expected.lost += static_cast<double>(own.size()) * lost;
    for (std::uint32_t j = own.first; j < own.last; ++j) {
      const double found_u = scratch.block.u[j - all.first] + scratch.leaf.u[j - own.first];
      const double found_v = scratch.block.v[j - all.first] + scratch.leaf.v[j - own.first];
      expected.found += found_u * found_u + found_v * found_v;
      u[order[j]] = found_u, v[order[j]] = found_v;
    }
  }
  return expected;
}

template <class Pair>
Expected evaluate_with(const ArrangedSources& sources, const Arrangement& targets,
                       const Acceptance& acceptance, bool coarse, std::span<double> u,
                       std::span<double> v) {
  const std::vector<BlockOfLeaves> blocks = gather_blocks(targets.tree);
  std::vector<Expected> expected(blocks.size());
  tree::share_in_turn(
      tree::all_of(blocks.size()), 1, blocks.size() > 1, [] { return Scratch(); },
      [&](std::uint32_t k, Scratch& scratch) {
        expected[k] =
            evaluate_block<Pair>(sources, targets, blocks[k], acceptance, coarse, scratch, u, v);
      });
  return total(expected);
}

}  // namespace

Expected evaluate(const ArrangedSources& sources, const Arrangement& targets,
                  const Acceptance& acceptance, bool coarse, std::span<double> u,
                  std::span<double> v) {
  if (acceptance.reach2 == 0.0) {
    return evaluate_with<BarePair>(sources, targets, acceptance, coarse, u, v);
  }
  Expected expected;
  with_pair(acceptance.cores, coarse, [&]<class Pair>() {
    expected = evaluate_with<Pair>(sources, targets, acceptance, coarse, u, v);
  });
  return expected;
}

Work count_work(const ArrangedSources& sources, const Arrangement& targets,
                const Acceptance& acceptance) {
  Work work;
  Scratch scratch;
  const auto add = [&](std::span<const SeriesCell> series, std::uint64_t n) {
    work.series += series.size();
    for (const SeriesCell met : series) work.terms += n * static_cast<std::uint64_t>(met.terms);
  };
  for (const BlockOfLeaves& block : gather_blocks(targets.tree)) {
    find_shared(sources.at.tree, sources.at.shapes, box(targets.shapes, block.cell), acceptance,
                scratch.shared);
    add(scratch.shared.series, targets.tree.cells()[block.cell].points.size());
    for (std::uint32_t k = block.first; k < block.last; ++k) {
      const std::uint32_t leaf = targets.tree.childless()[k];
      const std::uint64_t n = targets.tree.cells()[leaf].points.size();
      const TargetBox target = box(targets.shapes, leaf);
      find_interactions(sources.at.tree, sources.at.shapes, target, acceptance,
                        scratch.shared.waiting, scratch.found);
      scratch.near.pack(sources.at.points, sources.gamma, target, acceptance, scratch.found);
      add(scratch.found.series, n);
      work.bare += n * scratch.near.bare();
      work.cored += n * scratch.near.cored();
    }
  }
  return work;
}

}  // namespace vortree::fmm
