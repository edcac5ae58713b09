#include "tree/neighbors/neighbors.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tree/base/tuning.hpp"
#include "tree/cells/deep_cells.hpp"
#include "tree/cells/home_cells.hpp"

namespace vortree::tree {

namespace {

void check_sizes(std::size_t in_tree, Points points, std::span<const double> reach) {
  std::ostringstream text;
  if (points.x.size() != points.y.size()) {
    text << points.x.size() << " x but " << points.y.size() << " y coordinates";
  } else if (reach.size() != points.size()) {
    text << points.size() << " points but " << reach.size() << " reaches";
  } else if (in_tree != points.size()) {
    text << points.size() << " points, but the tree holds " << in_tree;
  } else if (points.size() > std::numeric_limits<std::int32_t>::max()) {
    text << points.size() << " points; at most 2^31 - 1 can be listed";
  } else {
    return;
  }
  throw std::invalid_argument("neighbors: " + text.str());
}

}  // namespace

void Neighbors::place(Points points, std::span<const double> reach) {
  check_sizes(points.size(), points, reach);
  settle(sort_into_own_cells(points, reach, placed_));
}

void Neighbors::place(const Quadtree& tree, Points points, std::span<const double> reach) {
  check_sizes(tree.order().size(), points, reach);
  settle(sort_into_own_cells(tree, points, reach, placed_));
}

void Neighbors::settle(const HomeCells& own) {
  if (too_shallow(own, placed_)) {
    const DeepCells deep = deepen(placed_, few_particles);
    find_content(deep.cells, deep.level, deep.first);
    find_colleagues(deep.cells, colleagues_);
    find_coarser(deep.cells);
    return make_groups(deep.cells, deep.sides);
  }
  const Quadtree tree = own.tree(few_particles);
  std::array<double, max_level + 1> sides{};
  for (int level = 0; level <= tree.depth(); ++level) sides[level] = tree.side(level);
  find_content(tree.cells(), own.level, own.first);
  find_colleagues(tree, colleagues_);
  find_coarser(tree.cells());
  make_groups(tree.cells(), sides);
}

// In the run of own cells that lie in a cell, those of its ancestors that share its corner come
// first, then its own: one, or if it is childless all that are left.
void Neighbors::find_content(std::span<const Cell> cells, std::span<const std::int16_t> level,
                             std::span<const std::uint32_t> particles) {
  content_.resize(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const Range inside = cells[c].points;
    std::uint32_t first = inside.first;
    while (first < inside.last && level[first] < cells[c].level) ++first;
    std::uint32_t finer = first;
    while (finer < inside.last && level[finer] == cells[c].level) ++finer;
    if (cells[c].childless()) finer = inside.last;
    content_[c] = {particles[first], particles[finer], particles[inside.last]};
  }
}

void Neighbors::find_coarser(std::span<const Cell> cells) {
  coarser_.assign(cells.size(), -1);
  for (std::size_t c = 1; c < cells.size(); ++c) {
    const std::int32_t parent = cells[c].parent;
    const auto owns = [&](std::int32_t k) {
      return k >= 0 && content_[k].first < content_[k].finer;
    };
    // All four children ask the same; who follows a sibling takes its answer.
    coarser_[c] = parent == cells[c - 1].parent                    ? coarser_[c - 1]
                  : std::ranges::any_of(colleagues_[parent], owns) ? parent
                                                                   : coarser_[parent];
  }
}

// In search order, so that what lies together is searched together.
void Neighbors::make_groups(std::span<const Cell> cells, std::span<const double> sides) {
  groups_.clear();
  std::vector<std::uint32_t> path;
  if (!cells.empty()) path.push_back(0);
  while (!path.empty()) {
    const std::uint32_t c = path.back();
    path.pop_back();
    const Range own{content_[c].first, content_[c].finer};
    for (std::uint32_t first = own.first; first < own.last; first += largest_group) {
      groups_.push_back(
          {{first, std::min(own.last, first + largest_group)}, c, sides[cells[c].level]});
    }
    if (content_[c].finer == content_[c].last) continue;
    for (std::uint32_t k = cells[c].children.last; k-- > cells[c].children.first;)
      path.push_back(k);
  }
}

void Neighbors::name_candidates(const Group& group, Listing listing,
                                std::vector<Range>& others) const {
  const auto cell = static_cast<std::int32_t>(group.cell);
  const bool once = listing == Listing::once;
  const Content& here = content_[cell];
  for (const std::int32_t k : colleagues_[cell]) {
    if (k < 0) continue;
    if (k == cell) {
      if (!once) others.push_back({here.first, group.own.first});
      others.push_back({group.own.last, here.last});
    } else {
      others.push_back(
          {once && k < cell ? content_[k].finer : content_[k].first, content_[k].last});
    }
  }
  if (once) return;
  for (std::int32_t above = coarser_[cell]; above >= 0; above = coarser_[above]) {
    for (const std::int32_t k : colleagues_[above]) {
      if (k >= 0) others.push_back({content_[k].first, content_[k].finer});
    }
  }
}

std::uint64_t Neighbors::candidates(Listing listing) const {
  std::uint64_t sum = 0;
  std::vector<Range> others;
  for (const Group& group : groups_) {
    others.clear();
    name_candidates(group, listing, others);
    std::uint64_t looked_at = group.own.size();
    for (const Range range : others) looked_at += range.size();
    sum += looked_at * group.own.size();
  }
  return sum;
}

void Neighbors::list(PairRule rule, Listing listing, PairList& rows) {
  if (rule == PairRule::own && listing == Listing::once) {
    throw std::invalid_argument(
        "neighbors: rule own is not symmetric; pairs cannot be listed once");
  }
  search_.list(
      placed_, groups_,
      [=, this](const Group& group, std::vector<Range>& others) {
        name_candidates(group, listing, others);
      },
      rule, listing, rows);
}

void Neighbors::visit(PairRule rule, Listing listing, const RowVisitor& visitor) {
  if (rule == PairRule::own && listing == Listing::once) {
    throw std::invalid_argument(
        "neighbors: rule own is not symmetric; pairs cannot be listed once");
  }
  search_.visit(
      placed_, groups_,
      [=, this](const Group& group, std::vector<Range>& others) {
        name_candidates(group, listing, others);
      },
      rule, listing, visitor);
}

std::size_t Neighbors::bytes() const {
  return placed_.x.bytes() + placed_.y.bytes() + placed_.reach.bytes() + placed_.id.bytes() +
         content_.capacity() * sizeof(Content) + colleagues_.capacity() * sizeof(Colleagues) +
         coarser_.capacity() * sizeof(std::int32_t) + groups_.capacity() * sizeof(Group) +
         search_.bytes();
}

PairList neighbors(Points points, std::span<const double> reach, PairRule rule, Listing listing) {
  Neighbors search;
  search.place(points, reach);
  PairList rows;
  search.list(rule, listing, rows);
  return rows;
}

}  // namespace vortree::tree
