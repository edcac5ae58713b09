#include "tree/build/assembly.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "tree/base/parallel.hpp"

namespace vortree::tree {

namespace {

using Levels = std::array<std::uint32_t, max_level + 2>;

// How many cells of each level some leaves begin.
Levels begun(const std::vector<Leaf>& leaves) {
  std::array<std::int64_t, max_level + 3> change{};
  for (const Leaf& leaf : leaves) {
    ++change[leaf.met + 1];
    --change[leaf.level + 1];
  }
  Levels count{};
  std::int64_t here = 0;
  for (int level = 0; level <= max_level; ++level) {
    here += change[level];
    count[level] = static_cast<std::uint32_t>(here);
  }
  return count;
}

// Walks along the leaves; knows the cells that are open and the next number of every level. Where a
// cell ends is never written by who begins it, so that one thread may close what another opens.
class Walk {
 public:
  Walk(std::span<const MortonKey> keys, std::vector<Cell>& cells, const Levels& next, int deepest)
      : keys_(keys), cells_(cells), next_(next), deepest_(deepest) {
    for (int level = 0; level <= max_level; ++level) open_[level] = next[level] - 1;
  }

  // Ends the open cells from a level down, before point `end`.
  void close(int from, std::uint32_t end) const {
    for (int level = from; level <= deepest_; ++level) {
      Cell& cell = cells_[open_[level]];
      cell.points.last = end;
      if (level < deepest_) cell.children.last = next_[level + 1];
    }
  }

  // Begins the cells of a leaf and returns the number of the last, its own.
  std::uint32_t open(const Leaf& leaf) {
    const MortonKey key = keys_[leaf.first];
    for (int level = leaf.met + 1; level <= leaf.level; ++level) {
      const std::uint32_t c = open_[level] = next_[level]++;
      Cell& cell = cells_[c];
      cell.key = ancestor(key, level);
      cell.level = level;
      cell.parent = level > 0 ? static_cast<std::int32_t>(open_[level - 1]) : -1;
      cell.children.first = level < leaf.level ? next_[level + 1] : 0;
      cell.points.first = leaf.first;
    }
    deepest_ = leaf.level;
    return open_[leaf.level];
  }

 private:
  std::span<const MortonKey> keys_;
  std::vector<Cell>& cells_;
  Levels next_, open_{};
  int deepest_;
};

// The number of the first cell of each level, of the first that each piece begins there, and so on.
struct Numbers {
  std::vector<Levels> first;  // by piece
  std::vector<std::uint32_t> level_first;
};

Numbers number(const LeavesByPiece& leaves) {
  Numbers numbers;
  numbers.first.resize(leaves.size());
  for_each_piece(leaves.size(), [&](std::size_t p) { numbers.first[p] = begun(leaves[p]); });
  std::uint64_t next = 0;
  for (int level = 0; level <= max_level; ++level) {
    const std::uint64_t first = next;
    for (Levels& levels : numbers.first) {
      next += std::exchange(levels[level], static_cast<std::uint32_t>(next));
    }
    if (next > first) numbers.level_first.push_back(static_cast<std::uint32_t>(first));
  }
  if (next > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max())) {
    throw std::invalid_argument("Quadtree: " + std::to_string(next) +
                                " cells; at most 2^31 - 1 fit");
  }
  numbers.level_first.push_back(static_cast<std::uint32_t>(next));
  return numbers;
}

}  // namespace

Quadtree Assembly::over(MortonOrder order) && {
  Quadtree tree;
  tree.order_ = std::move(order);
  tree.cells_ = std::move(cells);
  tree.level_first_ = std::move(level_first);
  tree.childless_ = std::move(childless);
  assert(tree == Quadtree(tree.order_, tree.cells_));
  return tree;
}

Assembly assemble(std::span<const MortonKey> keys, const LeavesByPiece& leaves) {
  Numbers numbers = number(leaves);
  Assembly grown{std::vector<Cell>(numbers.level_first.back()), std::move(numbers.level_first), {}};
  std::vector<std::size_t> rank(leaves.size() + 1, 0);
  std::vector<int> deepest(leaves.size() + 1, -1);  // before each piece
  for (std::size_t p = 0; p < leaves.size(); ++p) {
    rank[p + 1] = rank[p] + leaves[p].size();
    deepest[p + 1] = leaves[p].empty() ? deepest[p] : leaves[p].back().level;
  }
  grown.childless.resize(rank.back());
  for_each_piece(leaves.size(), [&](std::size_t p) {
    Walk walk(keys, grown.cells, numbers.first[p], deepest[p]);
    for (std::size_t i = 0; i < leaves[p].size(); ++i) {
      const Leaf& leaf = leaves[p][i];
      walk.close(leaf.met + 1, leaf.first);
      grown.childless[rank[p] + i] = walk.open(leaf);
    }
    if (p + 1 == leaves.size()) walk.close(0, static_cast<std::uint32_t>(keys.size()));
  });
  return grown;
}

// First the number of childless cells under each cell, from the leaves up; then the place of the
// first of them, from the root down.
std::vector<std::uint32_t> rank_childless(const std::vector<Cell>& cells) {
  std::vector<std::uint32_t> place(cells.size(), 0);
  for (std::size_t c = cells.size(); c-- > 0;) {
    place[c] += cells[c].childless();
    if (cells[c].parent >= 0) {
      place[cells[c].parent] += place[c];
    }
  }
  std::vector<std::uint32_t> ranked(cells.empty() ? 0 : place[0]);
  std::uint32_t next = 0;
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    next = c == 0 ? 0 : place[c];
    if (cells[c].childless()) {
      ranked[next] = c;
    }
    for (std::uint32_t k = cells[c].children.first; k < cells[c].children.last; ++k) {
      next += std::exchange(place[k], next);
    }
  }
  return ranked;
}

void check_order(const MortonOrder& order) {
  if (order.keys.size() != order.index.size()) {
    throw std::invalid_argument("Quadtree: " + std::to_string(order.keys.size()) + " keys but " +
                                std::to_string(order.index.size()) + " indices");
  }
  if (order.finest < 0 || order.finest > max_level) {
    throw std::invalid_argument("Quadtree: finest level is " + std::to_string(order.finest) +
                                "; it must be in 0.." + std::to_string(max_level));
  }
  assert(std::is_sorted(order.keys.begin(), order.keys.end()));
}

}  // namespace vortree::tree
