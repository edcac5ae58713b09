#include "fmm/geometry/deep_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fmm/tuning.hpp"
#include "tree/base/parallel.hpp"
#include "tree/order/encode_kernel.hpp"
#include "tree/order/radix_sort.hpp"
#include "tree/order/run_sort.hpp"

namespace vortree::fmm {
namespace {

/// a + b = sum + rest, exactly (Knuth).
void two_sum(double a, double b, double& sum, double& rest) {
  sum = a + b;
  const double second = sum - a;
  rest = (a - (sum - second)) + (b - second);
}

/// (x, rest) + step to twice the digits.
void move(double x, double rest, double step, double& moved, double& moved_rest) {
  double sum, lost;
  two_sum(x, step, sum, lost);
  two_sum(sum, lost + rest, moved, moved_rest);
}

CellFrame child_frame(const CellFrame& parent, int quadrant) {
  const double step = parent.side / 4;
  CellFrame child;
  move(parent.x, parent.x_rest, quadrant % 2 == 0 ? -step : step, child.x, child.x_rest);
  move(parent.y, parent.y_rest, quadrant / 2 == 0 ? -step : step, child.y, child.y_rest);
  child.side = 2 * step;
  return child;
}

/// Codes of the first n vortices of the order, at most `encoded_deep`, in the frame of their cell.
void encode_in(const CellFrame& at, std::span<const Vortex> vortices,
               std::span<const std::uint32_t> order, std::size_t n, tree::MortonKey* keys) {
  constexpr tree::kernel::DomainAxis axis{-0.5, 0.5, 0x1p31};
  std::array<double, encoded_deep> x, y;
  const auto local = [&](double value, double centre, double rest) {
    return std::clamp(((value - centre) - rest) / at.side, -0.5, 0.5);
  };
  for (std::size_t j = 0; j < n; ++j) {
    __builtin_prefetch(&vortices[order[std::min(j + encoded_ahead, order.size() - 1)]]);
    x[j] = local(vortices[order[j]].x, at.x, at.x_rest);
    y[j] = local(vortices[order[j]].y, at.y, at.y_rest);
  }
  static_cast<void>(
      tree::kernel::codes(x.data(), y.data(), n, axis, axis, ~tree::MortonKey{0}, keys));
}

}  // namespace

/// Cells that are split on, and where the points of each stand in the row of all such points.
struct DeepTree::Grafts {
  std::vector<std::uint32_t> cells;
  std::vector<tree::Range> runs;

  [[nodiscard]] std::uint32_t points() const { return runs.back().last; }
  /// All threads should sort it together.
  [[nodiscard]] bool large(std::size_t g) const { return runs[g].size() > tree::worth_sharing; }
  [[nodiscard]] std::size_t holder(std::uint32_t point) const {
    return std::ranges::upper_bound(runs, point, {}, &tree::Range::first) - runs.begin() - 1;
  }
};

DeepTree::DeepTree(const tree::Quadtree& base, std::span<const Vortex> vortices, const Units& units,
                   std::uint32_t capacity, bool deepen) {
  take(base);
  if (cells_.empty()) return;
  set_frames(0, base.domain(), units);
  const Grafts grafts = deepen ? find_full(base, capacity) : Grafts{};
  if (grafts.cells.empty()) return;
  const Unwritten<tree::MortonKey> keys = sort(grafts, vortices);
  append(grafts, tree::grow_forest(keys, grafts.runs, {capacity}, tree::pieces_of(keys.size())));
  set_frames(base.depth() + 1, base.domain(), units);
}

double DeepTree::side(int level) const {
  return std::ldexp(frames_[0].side, -level);
}

void DeepTree::take(const tree::Quadtree& base) {
  const auto cells = base.cells();
  cells_.resize(cells.size());
  const bool shared = cells.size() > tree::cells_worth_sharing;
  tree::share_evenly(tree::all_of(cells.size()), shared, [&](std::uint32_t c) {
    const tree::Cell& from = cells[c];
    cells_[c] = {from.level, static_cast<int>(from.key & 3), from.parent, from.children,
                 from.points};
  });
  const auto order = base.order();
  order_.resize(order.size());
  tree::share_evenly(tree::all_of(order.size()), order.size() > tree::worth_sharing,
                     [&](std::uint32_t j) { order_[j] = order[j]; });
  childless_.assign(base.childless().begin(), base.childless().end());
  for (int level = 0; level <= base.depth(); ++level) {
    level_first_.push_back(base.level(level).last);
  }
}

void DeepTree::set_frames(int from, const tree::Domain& domain, const Units& units) {
  frames_.resize(cells_.size());
  if (from == 0) {
    const double half = domain.side / 2 * units.per_length;
    CellFrame& root = frames_[0];
    root.side = 2 * half;
    two_sum(domain.x0 * units.per_length, half, root.x, root.x_rest);
    two_sum(domain.y0 * units.per_length, half, root.y, root.y_rest);
  }
  for (int l = std::max(from, 1); l <= depth(); ++l) {
    const tree::Range range = level(l);
    tree::share_evenly(range, range.size() > tree::cells_worth_sharing, [&](std::uint32_t c) {
      frames_[c] = child_frame(frames_[cells_[c].parent], cells_[c].quadrant);
    });
  }
}

DeepTree::Grafts DeepTree::find_full(const tree::Quadtree& base, std::uint32_t capacity) const {
  Grafts grafts;
  std::uint32_t next = 0;
  const tree::Range finest = base.level(base.finest());
  for (std::uint32_t c = finest.first; c < finest.last; ++c) {
    const std::uint32_t size = cells_[c].points.size();
    if (size <= capacity) continue;
    grafts.cells.push_back(c);
    grafts.runs.push_back({next, next + size});
    next += size;
  }
  return grafts;
}

/// Puts the points of each graft in the order of their codes there, which are returned.
Unwritten<tree::MortonKey> DeepTree::sort(const Grafts& grafts, std::span<const Vortex> vortices) {
  Unwritten<tree::MortonKey> keys = encode(grafts, vortices);
  const auto keys_of = [&](std::size_t g) {
    return std::span(keys).subspan(grafts.runs[g].first, grafts.runs[g].size());
  };
  const auto order_of = [&](std::size_t g) {
    return std::span(order_).subspan(cells_[grafts.cells[g]].points.first, grafts.runs[g].size());
  };
  for (std::size_t g = 0; g < grafts.cells.size(); ++g) {
    if (grafts.large(g)) tree::radix_sort(keys_of(g), order_of(g));
  }
  tree::share_in_turn(
      tree::all_of(grafts.cells.size()), 16, grafts.points() > tree::deep_points_worth_sharing,
      [] { return tree::RunSort(); },
      [&](std::uint32_t g, tree::RunSort& sort_run) {
        if (grafts.runs[g].size() <= tree::RunSort::most_whole) {
          sort_run.whole(keys_of(g), order_of(g));
        } else if (!grafts.large(g)) {
          tree::radix_sort(keys_of(g), order_of(g));
        }
      });
  return keys;
}

/// Codes of points in the frames of their grafts.
Unwritten<tree::MortonKey> DeepTree::encode(const Grafts& grafts,
                                            std::span<const Vortex> vortices) const {
  const std::uint32_t n = grafts.points();
  Unwritten<tree::MortonKey> keys(n);
  const std::uint32_t parts = (n + encoded_deep - 1) / encoded_deep;
  tree::share_evenly({0, parts}, n > tree::deep_points_worth_sharing, [&](std::uint32_t part) {
    const std::uint32_t begin = part * encoded_deep, end = std::min(n, begin + encoded_deep);
    std::size_t g = grafts.holder(begin);
    for (std::uint32_t first = begin; first < end; ++g) {
      const std::uint32_t last = std::min(end, grafts.runs[g].last);
      const DeepCell& cell = cells_[grafts.cells[g]];
      const std::uint32_t place = cell.points.first + (first - grafts.runs[g].first);
      encode_in(frames_[grafts.cells[g]], vortices, std::span(order_).subspan(place), last - first,
                &keys[first]);
      first = last;
    }
  });
  return keys;
}

/// The forest without its roots, which are cells already, comes after all cells.
void DeepTree::append(const Grafts& grafts, const tree::Assembly& forest) {
  const auto before = static_cast<std::uint32_t>(cells_.size());
  const std::uint32_t roots = forest.level_first[1], finest = depth();
  const auto moved = [=](std::uint32_t c) { return c - roots + before; };
  cells_.resize(moved(static_cast<std::uint32_t>(forest.cells.size())));
  for (std::uint32_t g = 0; g < roots; ++g) {
    const tree::Range children = forest.cells[g].children;
    cells_[grafts.cells[g]].children = {moved(children.first), moved(children.last)};
  }
  const tree::Range grown{roots, static_cast<std::uint32_t>(forest.cells.size())};
  tree::share_evenly(grown, grown.last > tree::cells_worth_sharing, [&](std::uint32_t c) {
    const tree::Cell& from = forest.cells[c];
    const std::size_t g = grafts.holder(from.points.first);
    const std::uint32_t shift = cells_[grafts.cells[g]].points.first - grafts.runs[g].first;
    const auto above = static_cast<std::uint32_t>(from.parent);
    cells_[moved(c)] = {static_cast<int>(finest) + from.level,
                        static_cast<int>(from.key & 3),
                        static_cast<std::int32_t>(above < roots ? grafts.cells[g] : moved(above)),
                        from.childless()
                            ? tree::Range{}
                            : tree::Range{moved(from.children.first), moved(from.children.last)},
                        {from.points.first + shift, from.points.last + shift}};
  });
  for (std::size_t l = 2; l < forest.level_first.size(); ++l) {
    level_first_.push_back(moved(forest.level_first[l]));
  }
  Unwritten<std::uint32_t> ranked;
  ranked.reserve(childless_.size() + forest.childless.size());
  std::size_t g = 0, next = 0;
  for (const std::uint32_t c : childless_) {
    if (g == roots || grafts.cells[g] != c) {
      ranked.push_back(c);
      continue;
    }
    for (; next < forest.childless.size(); ++next) {
      const std::uint32_t leaf = forest.childless[next];
      if (forest.cells[leaf].points.first >= grafts.runs[g].last) break;
      ranked.push_back(moved(leaf));
    }
    ++g;
  }
  childless_ = std::move(ranked);
}

std::size_t DeepTree::bytes() const {
  return cells_.capacity() * (sizeof(DeepCell) + sizeof(CellFrame)) +
         sizeof(std::uint32_t) *
             (level_first_.capacity() + childless_.capacity() + order_.capacity());
}

}  // namespace vortree::fmm
