#include "tree/build_reverse.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tree/search_kernel.hpp"

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

class Climber {
 public:
  Climber(const MortonOrder& order, const SplitRule& must_split)
      : keys_(order.keys), domain_(order.domain), finest_(order.finest), must_split_(must_split) {}

  // The childless cell that begins at point `first`, given that all points before it are in other
  // such cells. `start` is a level to begin the climb at, if the rule lets it.
  [[nodiscard]] Leaf climb(std::uint32_t first, int start) const {
    int refused = meeting_level(keys_, first);
    Block here = footing(first, std::max(start, refused + 1), refused);
    for (int above = meeting_level(keys_, here.points.last); above > refused;
         above = meeting_level(keys_, here.points.last)) {
      const Block merged = grown(here, above);
      if (must_split_(merged)) {
        refused = above;
      } else {
        here = merged;
      }
    }
    const int joined = std::max(refused, meeting_level(keys_, here.points.last));
    return {coarsest(joined + 1, here), here.points};
  }

 private:
  // The cell of a level that begins with the points of a block inside it.
  [[nodiscard]] Block grown(const Block& block, int level) const {
    const Key cell = ancestor(keys_[block.points.first], level);
    const Key beyond = first_descendant(cell + 1, level);
    const std::uint32_t last = kernel::gallop(keys_, block.points.last, beyond);
    return {level, domain_.cell_side(level), {block.points.first, last}};
  }

  // A cell that begins at `first` and need not split: of the given level or below, tried in steps
  // that double, down to the finest. Sets `refused` to the last level at which it had to split.
  [[nodiscard]] Block footing(std::uint32_t first, int level, int& refused) const {
    for (int step = 1;; step *= 2) {
      const Block block = grown({level, 0, {first, first}}, level);
      if (level == finest_ || !must_split_(block)) {
        return block;
      }
      refused = level;
      level = std::min(level + step, finest_);
    }
  }

  // The coarsest level, from `low` down to its own, at which the points of a block, alone in their
  // cell, need not split.
  [[nodiscard]] int coarsest(int low, const Block& block) const {
    int high = block.level;
    const auto refuses = [&](int level) {
      return must_split_({level, domain_.cell_side(level), block.points});
    };
    if (low == high || !refuses(low)) {
      return low;
    }
    ++low;
    while (low < high) {
      const int middle = (low + high) / 2;
      if (refuses(middle)) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  const std::vector<Key>& keys_;
  const Domain& domain_;
  int finest_;
  const SplitRule& must_split_;
};

std::vector<Leaf> childless_cells(const MortonOrder& order, const SplitRule& must_split) {
  const Climber climber(order, must_split);
  std::vector<Leaf> leaves;
  int level = order.finest;
  for (std::uint32_t first = 0; first < order.keys.size(); first = leaves.back().points.last) {
    leaves.push_back(climber.climb(first, level));
    level = leaves.back().level;
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
