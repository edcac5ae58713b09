#include "tree/build/build_reverse.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tree/base/parallel.hpp"
#include "tree/build/assembly.hpp"
#include "tree/build/search_kernel.hpp"

namespace vortree::tree {

namespace {

// A childless cell by its points.
struct ClimbedCell {
  int level;
  std::uint32_t last;
};

// Finds childless cells by climbing, for any rule.
class Climber {
 public:
  Climber(const MortonOrder& order, const SplitRule& must_split)
      : keys_(order.keys), domain_(order.domain), finest_(order.finest), must_split_(must_split) {}

  // The childless cell that begins at point `first`, which meets the point before at level `met`.
  // `start` is a level to begin the climb at, if the rule lets it.
  [[nodiscard]] ClimbedCell climb(std::uint32_t first, int met, int start) const {
    int refused = met;
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
    return {coarsest(joined + 1, here), here.points.last};
  }

  // Where the childless cell that holds a point ends.
  [[nodiscard]] std::uint32_t end_of_cell(std::uint32_t point) const {
    int low = 0, high = finest_;
    while (low < high) {
      const int middle = (low + high) / 2;
      if (must_split_(around(point, middle))) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return around(point, low).points.last;
  }

 private:
  // The cell of a level that holds a point.
  [[nodiscard]] Block around(std::uint32_t point, int level) const {
    const Range all{0, static_cast<std::uint32_t>(keys_.size())};
    const MortonKey cell = ancestor(keys_[point], level);
    const std::uint32_t first = kernel::lower_bound(keys_, all, first_descendant(cell, level));
    return grown({level, 0, {first, first}}, level);
  }

  // The cell of a level that begins with the points of a block inside it.
  [[nodiscard]] Block grown(const Block& block, int level) const {
    const MortonKey cell = ancestor(keys_[block.points.first], level);
    const MortonKey beyond = first_descendant(cell + 1, level);
    const std::uint32_t last = kernel::gallop(keys_, block.points.last, beyond);
    return {level, domain_.cell_side(level), {block.points.first, last}};
  }

  // A cell that begins at `first` and need not split: of the given level or below, tried in steps
  // that double, down to the finest. Sets `refused` to the last level at which it had to split.
  [[nodiscard]] Block footing(std::uint32_t first, int level, int& refused) const {
    level = std::min(level, finest_);
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
    if (low >= high || !refuses(low)) {
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

  std::span<const MortonKey> keys_;
  const Domain& domain_;
  int finest_;
  const SplitRule& must_split_;
};

// Crowding needs no climb: a cell that begins at a point is crowded if it holds the one n_ctrl
// places on, and it must not hold the one before.
class Reacher {
 public:
  Reacher(std::span<const MortonKey> keys, int finest, CrowdedRule rule)
      : keys_(keys), finest_(finest), n_ctrl_(rule.n_ctrl) {}

  [[nodiscard]] ClimbedCell climb(std::uint32_t first, int met, int /*start*/) const {
    const auto n = static_cast<std::uint32_t>(keys_.size());
    const bool many = n - first > n_ctrl_;
    const int crowded = many ? common_level(keys_[first], keys_[first + n_ctrl_]) : -1;
    const int level = std::min(finest_, 1 + std::max(met, crowded));
    const MortonKey beyond = first_descendant(ancestor(keys_[first], level) + 1, level);
    const std::uint32_t reach = many ? first + n_ctrl_ : n;
    const std::uint32_t last = kernel::lower_bound(keys_, {first, reach}, beyond);
    // Only at the finest level there may be more.
    return {level, last < reach ? last : kernel::gallop(keys_, last, beyond)};
  }

  [[nodiscard]] std::uint32_t end_of_cell(std::uint32_t point) const {
    const std::uint32_t before = point - std::min(point, n_ctrl_);
    const auto n = static_cast<std::uint32_t>(keys_.size());
    int crowded = -1;
    for (std::uint32_t j = before; j <= point && n - j > n_ctrl_; ++j) {
      crowded = std::max(crowded, common_level(keys_[j], keys_[j + n_ctrl_]));
    }
    const int level = std::min(finest_, 1 + crowded);
    return kernel::gallop(keys_, point, first_descendant(ancestor(keys_[point], level) + 1, level));
  }

 private:
  std::span<const MortonKey> keys_;
  int finest_;
  std::uint32_t n_ctrl_;
};

// Appends the childless cells that begin in some piece of the points. Leaves count points from
// `offset`.
template <class Finder>
void add_leaves(Range points, std::span<const MortonKey> keys, const Finder& finder,
                std::uint32_t offset, std::vector<Leaf>& leaves) {
  int level = max_level;
  std::uint32_t first = points.first == 0 ? 0 : finder.end_of_cell(points.first - 1);
  while (first < points.last) {
    const int met = meeting_level(keys, first);
    const ClimbedCell run = finder.climb(first, met, level);
    level = run.level;
    leaves.push_back(
        {offset + first, static_cast<std::int16_t>(met), static_cast<std::int16_t>(level)});
    first = run.last;
  }
}

template <class Finder>
LeavesByPiece find_leaves(std::span<const MortonKey> keys, const Finder& finder,
                          std::size_t pieces) {
  LeavesByPiece leaves(pieces);
  for_each_piece(pieces, [&](std::size_t p) {
    add_leaves(piece(keys.size(), p, pieces), keys, finder, 0, leaves[p]);
  });
  return leaves;
}

}  // namespace

Assembly grow_reverse(const MortonOrder& order, const SplitRule& must_split, std::size_t pieces) {
  const auto* crowded = must_split.target<CrowdedRule>();
  const LeavesByPiece leaves =
      crowded ? find_leaves(order.keys, Reacher(order.keys, order.finest, *crowded), pieces)
              : find_leaves(order.keys, Climber(order, must_split), pieces);
  return assemble(order.keys, leaves);
}

Assembly grow_forest(std::span<const MortonKey> keys, std::span<const Range> runs,
                     CrowdedRule must_split, std::size_t pieces) {
  LeavesByPiece leaves(pieces);
  for_each_piece(pieces, [&](std::size_t p) {
    const Range part = piece(keys.size(), p, pieces);
    auto run = std::ranges::upper_bound(runs, part.first, {}, &Range::first) - 1;
    for (; run != runs.end() && run->first < part.last; ++run) {
      const std::span<const MortonKey> own = keys.subspan(run->first, run->size());
      const std::uint32_t first = std::max(part.first, run->first) - run->first;
      const std::uint32_t last = std::min(part.last, run->last) - run->first;
      add_leaves({first, last}, own, Reacher(own, max_level, must_split), run->first, leaves[p]);
    }
  });
  return assemble(keys, leaves);
}

Quadtree build_reverse(MortonOrder order, const SplitRule& must_split) {
  if (!must_split) {
    throw std::invalid_argument("build_reverse: the split rule is empty");
  }
  check_order(order);
  Assembly grown = grow_reverse(order, must_split, pieces_of(order.keys.size()));
  return std::move(grown).over(std::move(order));
}

}  // namespace vortree::tree
