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

bool acceptable(double reach) {
  return reach >= 0 && reach <= std::numeric_limits<double>::max();
}

// The least reach but zero, and the largest.
struct Extremes {
  double least = INFINITY, most = 0;
};

// Doubles >= 0 are ordered as their bits are, and whole numbers may be compared many at a time.
Extremes check_reaches(std::span<const double> reach) {
  constexpr auto infinity = std::bit_cast<std::int64_t>(std::numeric_limits<double>::infinity());
  std::int64_t low = infinity, least = infinity, most = 0;
  for (const double r : reach) {
    const auto bits = std::bit_cast<std::int64_t>(r);
    low = std::min(low, bits);
    least = std::min(least, bits > 0 ? bits : infinity);
    most = std::max(most, bits);
  }
  const auto bad = low >= 0 && most < infinity
                       ? reach.end()
                       : std::find_if_not(reach.begin(), reach.end(), acceptable);
  if (bad == reach.end()) return {std::bit_cast<double>(least), std::bit_cast<double>(most)};
  std::ostringstream text;
  text.precision(17);
  text << "neighbors: reach[" << bad - reach.begin() << "] is " << *bad
       << "; it must be finite and >= 0";
  throw std::invalid_argument(text.str());
}

// The domain so much larger that the cells of some level are as wide as the largest reach.
Domain fit(const Domain& tight, double largest) {
  const double wide = largest * (1 + 0x1p-17);
  if (!(wide > 0 && wide < tight.side && tight.side < 0x1p1000)) return tight;
  const double cells = tight.side / wide;
  return enlarge(tight, std::exp2(std::ceil(std::log2(cells))) / cells);
}

std::uint32_t ancestor(std::span<const Cell> cells, std::uint32_t cell, int levels) {
  for (int up = 0; up < levels; ++up) cell = static_cast<std::uint32_t>(cells[cell].parent);
  return cell;
}

// The deepest level whose cells span a reach.
int own_level(double side, double reach) {
  const double cells = side / (reach * margin);
  if (!(cells >= 2)) return 0;
  const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(cells) >> 52) - 1023;
  return std::min(exponent, max_level);
}

}  // namespace

namespace {

void sort_reaches(std::span<const std::uint32_t> order, std::span<const double> reach,
                  Buffer<double>& sorted) {
  sorted.renew(order.size());
#pragma omp parallel for schedule(static)
  for (std::size_t j = 0; j < order.size(); ++j) sorted[j] = reach[order[j]];
}

// A tree whose cells of some level are as wide as the largest reach; `sorted` in its order.
Quadtree build(Points points, std::span<const double> reach, Buffer<double>& sorted) {
  check_sizes(points.size(), points, reach);
  const Extremes extremes = check_reaches(reach);
  const Domain domain = fit(enclose(points), extremes.most);
  MortonOrder order = morton_order(points, domain, own_level(domain.side, extremes.least));
  sort_reaches(order.index, reach, sorted);
  // The rule looks at reaches as they are: margin in the domain instead.
  SplitRule rule = both(crowded(few), roomy(sorted.span()));
  return build_reverse(std::move(order), rule);
}

}  // namespace

Quadtree build_for_reach(Points points, std::span<const double> reach) {
  Buffer<double> sorted;
  return build(points, reach, sorted);
}

// How far each point's own cell is above its leaf, and how many points each cell owns.
void Neighbors::find_cells(const Quadtree& tree) {
  const auto cells = tree.cells();
  const auto leaves = tree.childless();
  const double side = tree.domain().side;
  rise_.resize(tree.order().size());
  content_.assign(cells.size(), {});
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    const Cell& leaf = cells[leaves[k]];
    std::uint32_t at_home = 0;
    for (std::uint32_t j = leaf.points.first; j < leaf.points.last; ++j) {
      const int rise = std::max(0, leaf.level - own_level(side, sorted_[j]));
      rise_[j] = static_cast<std::uint8_t>(rise);
      at_home += rise == 0;
      if (rise == 0) continue;
      std::uint32_t& away = content_[ancestor(cells, leaves[k], rise)].finer;
#pragma omp atomic
      ++away;
    }
#pragma omp atomic
    content_[leaves[k]].finer += at_home;
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

void Neighbors::fill(const Quadtree& tree, Points points) {
  const auto cells = tree.cells();
  const auto put = [&](std::uint32_t place, std::uint32_t j) {
    const std::uint32_t i = tree.order()[j];
    placed_.x[place] = points.x[i];
    placed_.y[place] = points.y[i];
    placed_.reach[place] = sorted_[j];
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
      if (rise_[j] == 0) put(place++, j);
      all_in_leaves = all_in_leaves && rise_[j] == 0;
    }
  }
  if (all_in_leaves) return;
  std::vector<std::uint32_t> taken(cells.size(), 0);
  for (const std::uint32_t leaf : leaves) {
    for (std::uint32_t j = cells[leaf].points.first; j < cells[leaf].points.last; ++j) {
      if (rise_[j] == 0) continue;
      const std::uint32_t cell = ancestor(cells, leaf, rise_[j]);
      put(content_[cell].first + taken[cell]++, j);
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

void Neighbors::place(Points points, std::span<const double> reach) {
  const Quadtree tree = build(points, reach, sorted_);
  place_sorted(tree, points);
}

void Neighbors::place(const Quadtree& tree, Points points, std::span<const double> reach) {
  check_sizes(tree.order().size(), points, reach);
  check_reaches(reach);
  sort_reaches(tree.order(), reach, sorted_);
  place_sorted(tree, points);
}

void Neighbors::place_sorted(const Quadtree& tree, Points points) {
  find_cells(tree);
  lay_out(tree.cells());
  fill(tree, points);
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
         coarser_.capacity() * sizeof(std::int32_t) + rise_.capacity() + sorted_.bytes() +
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
