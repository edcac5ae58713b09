#include "tree/neighbors.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "tree/build_reverse.hpp"
#include "tree/split_rule.hpp"

namespace vortree::tree {

namespace {

// Reaches are taken so much larger that neither the rounding of codes (2^-20 of the finest cell)
// nor that of distances puts a neighbor two cells away.
constexpr double margin = 1 + 0x1p-18;

// Cells with no more particles than this are not worth splitting.
constexpr std::uint32_t few = 4;

// Larger groups are parted, for smaller boxes and for threads.
constexpr std::uint32_t largest_group = 64;

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

void check_reaches(std::span<const double> reach) {
  const auto acceptable = [](double r) {
    return r >= 0 && r <= std::numeric_limits<double>::max();
  };
  const auto bad = std::find_if_not(reach.begin(), reach.end(), acceptable);
  if (bad == reach.end()) return;
  std::ostringstream text;
  text.precision(17);
  text << "neighbors: reach[" << bad - reach.begin() << "] is " << *bad
       << "; it must be finite and >= 0";
  throw std::invalid_argument(text.str());
}

// The deepest level whose cells span a reach.
int own_level(double side, double reach) {
  const double cells = side / (reach * margin);
  if (!(cells >= 2)) return 0;
  const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(cells) >> 52) - 1023;
  return std::min(exponent, max_level);
}

}  // namespace

Domain reach_domain(Points points, std::span<const double> reach) {
  const Domain tight = enclose(points);
  double largest = 0;
  for (const double r : reach) largest = std::max(largest, r);
  const double fit = largest * (1 + 0x1p-17);
  if (!(fit > 0 && fit < tight.side && tight.side < 0x1p1000)) return tight;
  const double cells = tight.side / fit;
  return enlarge(tight, std::exp2(std::ceil(std::log2(cells))) / cells);
}

Quadtree build_for_reach(Points points, std::span<const double> reach) {
  check_sizes(points.size(), points, reach);
  check_reaches(reach);
  const Domain domain = reach_domain(points, reach);
  double least = INFINITY;
  for (const double r : reach) least = std::min(least, r > 0 ? r : INFINITY);
  MortonOrder order = morton_order(points, domain, own_level(domain.side, least));
  std::vector<double> sorted(reach.size());
#pragma omp parallel for schedule(static)
  for (std::size_t j = 0; j < sorted.size(); ++j) sorted[j] = margin * reach[order.index[j]];
  return build_reverse(std::move(order), both(roomy(sorted), crowded(few)));
}

// How far each point's own cell is above its leaf, and how many points each cell owns.
void Neighbors::find_cells(const Quadtree& tree, std::span<const double> reach) {
  const auto cells = tree.cells();
  const auto leaves = tree.childless();
  const double side = tree.domain().side;
  rise_.resize(tree.order().size());
  content_.assign(cells.size(), {});
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    const Cell& leaf = cells[leaves[k]];
    for (std::uint32_t j = leaf.points.first; j < leaf.points.last; ++j) {
      const int rise = std::max(0, leaf.level - own_level(side, reach[tree.order()[j]]));
      rise_[j] = static_cast<std::uint8_t>(rise);
      std::uint32_t cell = leaves[k];
      for (int up = 0; up < rise; ++up) cell = static_cast<std::uint32_t>(cells[cell].parent);
#pragma omp atomic
      ++content_[cell].finer;
    }
  }
}

// From the number of particles that each cell owns to where they are: those of a cell first, then
// those of its children.
void Neighbors::lay_out(std::span<const Cell> cells) {
  for (std::size_t c = cells.size(); c-- > 0;) {
    content_[c].last += content_[c].finer;
    if (cells[c].parent >= 0) content_[cells[c].parent].last += content_[c].last;
  }
  for (std::size_t c = 0; c < cells.size(); ++c) {
    content_[c].finer += content_[c].first;
    content_[c].last += content_[c].first;
    std::uint32_t next = content_[c].finer;
    for (std::uint32_t k = cells[c].children.first; k < cells[c].children.last; ++k) {
      content_[k].first = next;
      next += content_[k].last;
    }
  }
}

void Neighbors::fill(const Quadtree& tree, Points points, std::span<const double> reach) {
  const auto cells = tree.cells();
  const auto put = [&](std::uint32_t place, std::uint32_t i) {
    placed_.x[place] = points.x[i];
    placed_.y[place] = points.y[i];
    placed_.reach[place] = reach[i];
    placed_.id[place] = static_cast<std::int32_t>(i);
  };
  placed_.renew(points.size());
  const auto leaves = tree.childless();
  bool all_in_leaves = true;
#pragma omp parallel for schedule(static) reduction(&& : all_in_leaves)
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    const Range inside = cells[leaves[k]].points;
    std::uint32_t place = content_[leaves[k]].first;
    for (std::uint32_t j = inside.first; j < inside.last; ++j) {
      if (rise_[j] == 0) put(place++, tree.order()[j]);
      all_in_leaves = all_in_leaves && rise_[j] == 0;
    }
  }
  if (all_in_leaves) return;
  std::vector<std::uint32_t> taken(cells.size(), 0);
  for (const std::uint32_t leaf : leaves) {
    for (std::uint32_t j = cells[leaf].points.first; j < cells[leaf].points.last; ++j) {
      if (rise_[j] == 0) continue;
      std::uint32_t cell = leaf;
      for (int up = 0; up < rise_[j]; ++up) cell = static_cast<std::uint32_t>(cells[cell].parent);
      put(content_[cell].first + taken[cell]++, tree.order()[j]);
    }
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
void Neighbors::make_groups(const Quadtree& tree) {
  groups_.clear();
  const auto cells = tree.cells();
  std::vector<std::uint32_t> path;
  if (!cells.empty()) path.push_back(0);
  while (!path.empty()) {
    const std::uint32_t c = path.back();
    path.pop_back();
    const Range own{content_[c].first, content_[c].finer};
    for (std::uint32_t first = own.first; first < own.last; first += largest_group) {
      groups_.push_back(
          {{first, std::min(own.last, first + largest_group)}, c, tree.side(cells[c].level)});
    }
    if (content_[c].finer == content_[c].last) continue;
    for (std::uint32_t k = cells[c].children.last; k-- > cells[c].children.first;)
      path.push_back(k);
  }
}

void Neighbors::place(const Quadtree& tree, Points points, std::span<const double> reach) {
  check_sizes(tree.order().size(), points, reach);
  check_reaches(reach);
  find_cells(tree, reach);
  lay_out(tree.cells());
  fill(tree, points, reach);
  find_colleagues(tree, colleagues_);
  find_coarser(tree.cells());
  make_groups(tree);
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

void Neighbors::list(PairRule rule, Listing listing, Rows& rows) {
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
         coarser_.capacity() * sizeof(std::int32_t) + rise_.capacity() +
         groups_.capacity() * sizeof(Group) + search_.bytes();
}

Rows neighbors(const Quadtree& tree, Points points, std::span<const double> reach, PairRule rule,
               Listing listing) {
  Neighbors search;
  search.place(tree, points, reach);
  Rows rows;
  search.list(rule, listing, rows);
  return rows;
}

}  // namespace vortree::tree
