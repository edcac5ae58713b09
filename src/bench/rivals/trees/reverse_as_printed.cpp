#include <algorithm>
#include <utility>
#include <vector>

#include "bench/rivals/trees/tree_rivals.hpp"
#include "tree/build/assembly.hpp"

namespace vortree::bench {
namespace {

using tree::MortonKey;

// An occupied cell of the level at hand; key within the level.
struct Occupied {
  MortonKey key;
  std::uint32_t first, count;
};

struct FoundLeaf {
  std::uint32_t first;
  int level;
};

std::vector<Occupied> occupied(std::span<const MortonKey> keys, int level) {
  std::vector<Occupied> cells;
  for (std::uint32_t j = 0; j < keys.size(); ++j) {
    const MortonKey key = tree::ancestor(keys[j], level);
    if (cells.empty() || cells.back().key != key) cells.push_back({key, j, 0});
    ++cells.back().count;
  }
  return cells;
}

// Families come one after the other; the parents take the place of the cells. A cell that already
// had to split holds more than n_ctrl particles, and so does every cell around it.
void merge_families(std::vector<Occupied>& cells, int level, std::uint32_t n_ctrl, bool finest,
                    std::vector<FoundLeaf>& childless) {
  std::size_t parents = 0;
  for (std::size_t k = 0, last = 0; k < cells.size(); k = last) {
    const MortonKey parent = cells[k].key >> 2;
    std::uint32_t total = 0;
    for (last = k; last < cells.size() && cells[last].key >> 2 == parent; ++last) {
      total += cells[last].count;
    }
    if (total > n_ctrl) {
      for (std::size_t sibling = k; sibling < last; ++sibling) {
        if (cells[sibling].count <= n_ctrl || finest) {
          childless.push_back({cells[sibling].first, level});
        }
      }
    }
    cells[parents++] = {parent, cells[k].first, total};
  }
  cells.resize(parents);
}

}  // namespace

tree::Quadtree reverse_as_printed(tree::MortonOrder order, std::uint32_t n_ctrl, int start) {
  std::vector<Occupied> cells = occupied(order.keys, start);
  std::vector<FoundLeaf> childless;
  for (int level = start; level > 0; --level) {
    merge_families(cells, level, n_ctrl, level == order.finest, childless);
  }
  // The root, if everything merged.
  if (!cells.empty() && (cells[0].count <= n_ctrl || start == 0)) childless.push_back({0, 0});
  std::ranges::sort(childless, {}, &FoundLeaf::first);
  tree::LeavesByPiece leaves(1);
  for (const FoundLeaf& found : childless) {
    leaves[0].push_back({found.first,
                         static_cast<std::int16_t>(tree::meeting_level(order.keys, found.first)),
                         static_cast<std::int16_t>(found.level)});
  }
  return tree::assemble(order.keys, leaves).over(std::move(order));
}

}  // namespace vortree::bench
