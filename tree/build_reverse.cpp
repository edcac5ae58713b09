#include "tree/build_reverse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace vortree::tree {

namespace {

struct Leaf {
  int level;
  Range points;
};

// The level of the smallest cell that holds both a point and the one before it; -1 if there is no
// such cell.
int meeting_level(const std::vector<Key>& keys, std::uint32_t point) {
  return point == 0 || point == keys.size() ? -1 : common_level(keys[point - 1], keys[point]);
}

// The first point at or after `from` that lies beyond the cell of `key`. Steps double, since the
// end is usually near.
std::uint32_t end_of_cell(const std::vector<Key>& keys, std::uint32_t from, Key key, int level) {
  const Key beyond = first_descendant(ancestor(key, level) + 1, level);
  const std::size_t n = keys.size();
  std::size_t low = from, step = 1;
  while (low + step < n && keys[low + step] < beyond) {
    low += step;
    step *= 2;
  }
  const auto end =
      std::lower_bound(keys.begin() + low, keys.begin() + std::min(low + step, n), beyond);
  return static_cast<std::uint32_t>(end - keys.begin());
}

class Climber {
 public:
  Climber(const MortonOrder& order, const SplitRule& must_split)
      : order_(order), must_split_(must_split) {}

  // The childless cell that begins at point `first`, given that all points before it are in other
  // such cells.
  [[nodiscard]] Leaf climb(std::uint32_t first) const {
    const std::vector<Key>& keys = order_.keys;
    const int before = meeting_level(keys, first);
    int level = order_.finest;
    std::uint32_t last = end_of_cell(keys, first, keys[first], level);
    int refused = std::max(before, meeting_level(keys, last));
    while (refused > before) {
      const std::uint32_t merged = end_of_cell(keys, last, keys[first], refused);
      if (must_split_(block(refused, {first, merged}))) {
        break;
      }
      level = refused;
      last = merged;
      refused = std::max(before, meeting_level(keys, last));
    }
    return {coarsest(refused + 1, level, {first, last}), {first, last}};
  }

 private:
  [[nodiscard]] Block block(int level, Range points) const {
    return {level, std::ldexp(order_.domain.side, -level), points};
  }

  // The coarsest level in [low, high] at which these points, alone in their cell, need not split.
  [[nodiscard]] int coarsest(int low, int high, Range points) const {
    if (low == high || !must_split_(block(low, points))) {
      return low;
    }
    ++low;
    while (low < high) {
      const int middle = (low + high) / 2;
      if (must_split_(block(middle, points))) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  const MortonOrder& order_;
  const SplitRule& must_split_;
};

std::vector<Leaf> childless_cells(const MortonOrder& order, const SplitRule& must_split) {
  const Climber climber(order, must_split);
  std::vector<Leaf> leaves;
  for (std::uint32_t first = 0; first < order.keys.size(); first = leaves.back().points.last) {
    leaves.push_back(climber.climb(first));
  }
  return leaves;
}

// Walking the childless cells in Morton order, each begins new cells from just below the level at
// which it meets its predecessor down to its own; all others of its ancestors are there already.
class Assembly {
 public:
  Assembly(const std::vector<Key>& keys, const std::vector<Leaf>& leaves)
      : keys_(keys), leaves_(leaves) {}

  [[nodiscard]] std::vector<Cell> run() {
    std::vector<Cell> cells(place_levels());
    int deepest = -1;
    for (const Leaf& leaf : leaves_) {
      const int shared = meeting_level(keys_, leaf.points.first);
      close(cells, shared + 1, deepest, leaf.points.first);
      for (int level = shared + 1; level <= leaf.level; ++level) {
        open(cells, level, leaf.points.first);
      }
      deepest = leaf.level;
    }
    close(cells, 0, deepest, static_cast<std::uint32_t>(keys_.size()));
    return cells;
  }

 private:
  // Sets next_[l] to the number of the first cell of level l and returns the number of all cells.
  std::size_t place_levels() {
    std::array<std::int64_t, max_level + 2> change{};
    for (const Leaf& leaf : leaves_) {
      ++change[meeting_level(keys_, leaf.points.first) + 1];
      --change[leaf.level + 1];
    }
    std::int64_t in_level = 0, total = 0;
    for (int level = 0; level <= max_level; ++level) {
      next_[level] = static_cast<std::uint32_t>(total);
      in_level += change[level];
      total += in_level;
    }
    return static_cast<std::size_t>(total);
  }

  void open(std::vector<Cell>& cells, int level, std::uint32_t point) {
    const std::uint32_t cell = path_[level] = next_[level]++;
    cells[cell] = {ancestor(keys_[point], level), level, -1, {}, {point, point}};
    if (level > 0) {
      Cell& parent = cells[path_[level - 1]];
      cells[cell].parent = static_cast<std::int32_t>(path_[level - 1]);
      parent.children = {parent.childless() ? cell : parent.children.first, cell + 1};
    }
  }

  void close(std::vector<Cell>& cells, int first_level, int last_level, std::uint32_t end) const {
    for (int level = first_level; level <= last_level; ++level) {
      cells[path_[level]].points.last = end;
    }
  }

  const std::vector<Key>& keys_;
  const std::vector<Leaf>& leaves_;
  std::array<std::uint32_t, max_level + 1> next_{}, path_{};
};

}  // namespace

Quadtree build_reverse(MortonOrder order, const SplitRule& must_split) {
  if (!must_split) {
    throw std::invalid_argument("build_reverse: the split rule is empty");
  }
  const std::vector<Leaf> leaves = childless_cells(order, must_split);
  std::vector<Cell> cells = Assembly(order.keys, leaves).run();
  return Quadtree(std::move(order), std::move(cells));
}

}  // namespace vortree::tree
