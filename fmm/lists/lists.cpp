#include "fmm/lists/lists.hpp"

#include <numeric>

#include "fmm/tuning.hpp"
#include "tree/base/parallel.hpp"

namespace vortree::fmm {
namespace {

/// Where the neighbor (dx, dy) of the child in quadrant q is found: in the parent's neighbor
/// `near`, there in quadrant `quadrant`.
struct ChildPlace {
  int near, quadrant;
};

constexpr std::array<std::array<ChildPlace, 9>, 4> make_places() {
  std::array<std::array<ChildPlace, 9>, 4> places{};
  for (int q = 0; q < 4; ++q) {
    for (int k = 0; k < 9; ++k) {
      const int x = q % 2 + k % 3 + 1, y = q / 2 + k / 3 + 1;  // in the grid of the nine families
      places[q][k] = {3 * (y / 2) + x / 2, x % 2 + 2 * (y % 2)};
    }
  }
  return places;
}

constexpr auto places = make_places();

}  // namespace

CellRows::CellRows(std::size_t rows, std::span<const std::span<const Entry>> parts)
    : first_(rows + 2, 0u) {
  // counted two rows ahead, summed, and moved on as the cells go in: in the end one row ahead
  for (const auto part : parts) {
    for (const Entry entry : part) ++first_[entry.row + 2];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  cells_.resize(first_.back());
  for (const auto part : parts) {
    for (const Entry entry : part) cells_[first_[entry.row + 1]++] = entry.cell;
  }
  first_.pop_back();
}

/// Entries of the rows, as some cells find them.
struct InteractionLists::Found {
  Unwritten<CellRows::Entry> x, w, x_met, finer, refused;
};

InteractionLists::InteractionLists(const DeepTree& tree, std::uint32_t few, const Hidden& hidden) {
  if (tree.cells().empty()) return;
  find_kin(tree);
  find_neighbors(tree, hidden);
  find_meetings(tree, few, hidden);
}

void InteractionLists::find_kin(const DeepTree& tree) {
  const auto cells = tree.cells();
  const auto childless = tree.childless();
  const auto count = static_cast<std::uint32_t>(cells.size());
  children_.resize(count);
  leaves_.resize(count);
  level_.resize(count);
  marks_.resize(count);
  const bool shared = count > tree::cells_worth_sharing;
  tree::share_evenly({0, count}, shared, [&](std::uint32_t c) {
    level_[c] = static_cast<std::uint8_t>(cells[c].level);
    marks_[c] = static_cast<std::uint16_t>(cells[c].childless() << childless_bit);
    children_[c].fill(nobody);
    for (std::uint32_t k = cells[c].children.first; k < cells[c].children.last; ++k) {
      children_[c][cells[k].quadrant] = static_cast<std::int32_t>(k);
    }
  });
  tree::share_evenly(tree::all_of(childless.size()), shared, [&](std::uint32_t leaf) {
    leaves_[childless[leaf]] = {leaf, leaf + 1};
  });
  for (int level = tree.depth(); level >= 0; --level) {
    const tree::Range range = tree.level(level);
    tree::share_evenly(range, range.size() > tree::cells_worth_sharing, [&](std::uint32_t c) {
      const tree::Range children = cells[c].children;
      if (children.empty()) return;
      leaves_[c] = {leaves_[children.first].first, leaves_[children.last - 1].last};
    });
  }
}

void InteractionLists::find_neighbors(const DeepTree& tree, const Hidden& hidden) {
  const auto cells = tree.cells();
  neighbors_.resize(cells.size());
  neighbors_[0].fill(nobody);
  neighbors_[0][middle] = 0;
  for (int level = 0; level <= tree.depth(); ++level) {
    const tree::Range range = tree.level(level);
    const double gap = tree.side(level + 1);
    tree::share_evenly(range, range.size() > tree::cells_worth_sharing, [&](std::uint32_t c) {
      if (level > 0) find_neighbors_of(tree, c);
      unsigned marks = marks_[c];
      for (int k = 0; k < 9; ++k) {
        const std::int32_t q = neighbors_[c][k];
        if (q == nobody) continue;
        if (childless(q)) {
          marks |= 1u << leafy_bit;
        } else if (!childless(static_cast<std::int32_t>(c)) &&
                   (!hidden || hidden(c, static_cast<std::uint32_t>(q), gap))) {
          marks |= 1u << k;
        }
      }
      marks_[c] = static_cast<std::uint16_t>(marks);
    });
  }
}

void InteractionLists::find_neighbors_of(const DeepTree& tree, std::uint32_t c) {
  const DeepCell& cell = tree.cells()[c];
  const auto parent = static_cast<std::uint32_t>(cell.parent);
  for (int k = 0; k < 9; ++k) {
    const ChildPlace place = places[cell.quadrant][k];
    std::int32_t near = neighbors_[parent][place.near];
    if (near != nobody && !childless(near)) {
      near = open(parent, place.near) ? children_[near][place.quadrant] : nobody;
    }
    neighbors_[c][k] = near;
  }
}

void InteractionLists::find_meetings(const DeepTree& tree, std::uint32_t few,
                                     const Hidden& hidden) {
  const auto cells = tree.cells();
  const auto count = static_cast<std::uint32_t>(cells.size());
  for (const std::uint32_t b : tree.childless()) {
    if (cells[b].points.size() < few) {
      marks_[b] = static_cast<std::uint16_t>(marks_[b] | 1u << sparse_bit);
    }
  }
  const std::uint32_t portions = (count + cells_a_portion - 1) / cells_a_portion;
  std::vector<Found> some(portions);
  tree::share_in_turn({0, portions}, 1, portions > portions_for_one, [&](std::uint32_t p) {
    const std::uint32_t end = std::min(count, (p + 1) * cells_a_portion);
    for (std::uint32_t c = p * cells_a_portion; c < end; ++c) look(tree, c, hidden, some[p]);
  });
  const std::size_t leaves = tree.childless().size();
  struct Making {
    CellRows& rows;
    Unwritten<CellRows::Entry> Found::*entries;
    std::size_t count;
  };
  const Making makings[] = {{x_, &Found::x, count},
                            {w_, &Found::w, leaves},
                            {x_met_, &Found::x_met, count},
                            {finer_, &Found::finer, leaves},
                            {refused_, &Found::refused, count}};
  const auto make = [&](std::uint32_t m) {
    const Making& making = makings[m];
    std::vector<std::span<const CellRows::Entry>> parts;
    for (const Found& found : some) parts.emplace_back(found.*making.entries);
    making.rows = CellRows(making.count, parts);
  };
  tree::share_in_turn(tree::all_of(std::size(makings)), 1, portions > portions_for_one, make);
}

/// What c meets of its X, of coarser neighbors, and of families that refuse its own.
void InteractionLists::look(const DeepTree& tree, std::uint32_t c, const Hidden& hidden,
                            Found& found) const {
  const DeepCell& cell = tree.cells()[c];
  const Neighbors& own = neighbors_[c];
  const auto rank = [&](std::int32_t b) { return leaves_[b].first; };
  const auto number = [](std::int32_t b) { return static_cast<std::uint32_t>(b); };
  if (!cell.childless()) {
    for (int k = 0; hidden && k < 9; ++k) {
      if (own[k] != nobody && !childless(own[k]) && !open(c, k)) {
        found.refused.push_back({c, number(own[k])});
      }
    }
  } else if (marks_[c] >> leafy_bit & 1) {
    for (int k = 0; k < 9; ++k) {
      const std::int32_t b = own[k];
      if (b == nobody || !childless(b) || level_[b] == level_[c]) continue;
      if (std::find(own.begin(), own.begin() + k, b) == own.begin() + k) {
        found.finer.push_back({rank(b), c});
      }
    }
  }
  if (c == 0 || !(marks_[cell.parent] >> leafy_bit & 1)) return;
  const Neighbors& parents = neighbors_[cell.parent];
  for (int k = 0; k < 9; ++k) {
    const std::int32_t b = parents[k];
    if (b == nobody || !childless(b)) continue;
    if (std::ranges::find(own, b) != own.end()) continue;
    if (std::find(parents.begin(), parents.begin() + k, b) != parents.begin() + k) continue;
    if (marks_[c] >> sparse_bit & 1) {
      found.x_met.push_back({c, number(b)});
      found.finer.push_back({rank(b), c});
    } else if (!hidden || hidden(c, number(b), tree.side(cell.level))) {
      found.x.push_back({c, number(b)});
      found.w.push_back({rank(b), c});
    } else {
      found.refused.push_back({c, number(b)});
      found.refused.push_back({number(b), c});
    }
  }
}

std::size_t InteractionLists::bytes() const {
  const std::size_t per_cell = sizeof(Neighbors) + sizeof children_[0] + sizeof marks_[0] +
                               sizeof level_[0] + sizeof leaves_[0];
  return per_cell * neighbors_.capacity() + x_.bytes() + w_.bytes() + x_met_.bytes() +
         finer_.bytes() + refused_.bytes();
}

}  // namespace vortree::fmm
