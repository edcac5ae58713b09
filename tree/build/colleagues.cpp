#include "tree/build/colleagues.hpp"

#include "tree/base/parallel.hpp"

namespace vortree::tree {

namespace {

constexpr Colleagues nobody{-1, -1, -1, -1, -1, -1, -1, -1, -1};

// The children of nine colleagues, as 6 x 6 places of the level below.
class ColleaguePatch {
 public:
  ColleaguePatch(std::span<const Cell> cells, const Colleagues& parents) {
    place_.fill(-1);
    for (int k = 0; k < 9; ++k) {
      if (parents[k] < 0) continue;
      const Range children = cells[parents[k]].children;
      for (std::uint32_t child = children.first; child < children.last; ++child) {
        const auto q = static_cast<int>(cells[child].key & 3);
        at(2 * (k % 3) + q % 2, 2 * (k / 3) + q / 2) = static_cast<std::int32_t>(child);
      }
    }
  }

  // Around child q of the middle one.
  [[nodiscard]] Colleagues around(int q) {
    Colleagues found;
    for (int k = 0; k < 9; ++k) found[k] = at(1 + q % 2 + k % 3, 1 + q / 2 + k / 3);
    return found;
  }

 private:
  std::int32_t& at(int column, int row) { return place_[6 * row + column]; }
  std::array<std::int32_t, 36> place_;
};

void start(std::size_t cells, std::vector<Colleagues>& colleagues) {
  colleagues.resize(cells);
  if (cells == 0) return;
  colleagues[0] = nobody;
  colleagues[0][4] = 0;
}

void give_to_children(std::span<const Cell> cells, std::uint32_t parent,
                      std::vector<Colleagues>& colleagues) {
  if (cells[parent].childless()) return;
  ColleaguePatch patch(cells, colleagues[parent]);
  const Range children = cells[parent].children;
  for (std::uint32_t child = children.first; child < children.last; ++child) {
    colleagues[child] = patch.around(static_cast<int>(cells[child].key & 3));
  }
}

}  // namespace

void find_colleagues(const Quadtree& tree, std::vector<Colleagues>& colleagues) {
  const auto cells = tree.cells();
  start(cells.size(), colleagues);
  for (int level = 0; level < tree.depth(); ++level) {
    const Range parents = tree.level(level);
    share_evenly(parents, parents.size() > cells_worth_sharing,
                 [&](std::uint32_t parent) { give_to_children(cells, parent, colleagues); });
  }
}

void find_colleagues(std::span<const Cell> cells, std::vector<Colleagues>& colleagues) {
  start(cells.size(), colleagues);
  for (std::uint32_t c = 0; c < cells.size(); ++c) give_to_children(cells, c, colleagues);
}

}  // namespace vortree::tree
