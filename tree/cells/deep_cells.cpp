#include "tree/cells/deep_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "tree/base/tuning.hpp"
#include "tree/build/extent_kernel.hpp"
#include "tree/cells/exact_grid.hpp"
#include "tree/cells/home_cell_kernel.hpp"
#include "tree/order/radix_sort.hpp"

namespace vortree::tree {

namespace {

constexpr int levels_at_a_time = kernel::deepest_own;

struct OwnCell {
  std::uint32_t first;
  std::int16_t level;
};

// Particles that share a cell of a level.
struct Crowd {
  Range run;
  int level;
};

ExactGrid grid_of(const SortedParticles& placed) {
  double farthest = 0, largest = 0;
  for (std::size_t p = 0; p < placed.size; ++p) {
    farthest = std::max({farthest, std::abs(placed.x[p]), std::abs(placed.y[p])});
    largest = std::max(largest, placed.reach[p]);
  }
  return {farthest, largest};
}

// Sorts an order of particles.
class Sorting {
 public:
  Sorting(const SortedParticles& placed, const ExactGrid& grid)
      : placed_(placed), grid_(grid), order_(placed.size), keys_(placed.size) {
    std::iota(order_.begin(), order_.end(), 0u);
  }

  std::vector<OwnCell> sort() {
    waiting_.push_back({{0, static_cast<std::uint32_t>(placed_.size)}, 0});
    while (!waiting_.empty()) {
      const Crowd next = waiting_.back();
      waiting_.pop_back();
      part(next);
    }
    std::ranges::sort(cells_, {}, &OwnCell::first);
    return std::move(cells_);
  }

  [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }
  /// A level at which all share a cell.
  [[nodiscard]] int root() const { return root_; }

 private:
  // In one place they need no finer cell.
  void part(const Crowd& all) {
    const int base = start_of(all.run);
    if (all.run.size() <= deep_crowd || base >= ExactGrid::bottom) return add(all.run, all.level);
    if (all.level == 0) root_ = base;
    const std::size_t n = all.run.size();
    const std::span<MortonKey> keys(&keys_[all.run.first], n);
    const std::span<std::uint32_t> order(&order_[all.run.first], n);
    for (std::size_t k = 0; k < n; ++k) keys[k] = address(order[k], base);
    radix_sort(keys, order);
    for (std::uint32_t k = 0, end; k < n; k = end) {
      end = k + 1;
      while (end < n && keys[end] == keys[k]) ++end;
      const int level = kernel::Addresses{}.level(keys[k]);
      const Range run{all.run.first + k, all.run.first + end};
      if (level == levels_at_a_time && run.size() > deep_crowd) {
        waiting_.push_back({run, base + level});
      } else {
        add(run, base + level);
      }
    }
  }

  void add(Range run, int level) {
    cells_.push_back({run.first, static_cast<std::int16_t>(level)});
  }

  // The first level at which particles that do not all lie in one place part, or at which some of
  // them stay.
  [[nodiscard]] int start_of(Range run) const {
    const std::uint32_t one = order_[run.first];
    double left = placed_.x[one], right = left, low = placed_.y[one], high = low, largest = 0;
    for (std::uint32_t k = run.first; k < run.last; ++k) {
      const std::uint32_t p = order_[k];
      left = std::min(left, placed_.x[p]), right = std::max(right, placed_.x[p]);
      low = std::min(low, placed_.y[p]), high = std::max(high, placed_.y[p]);
      largest = std::max(largest, placed_.reach[p]);
    }
    const int shared = std::min(grid_.shared(left, right), grid_.shared(low, high));
    return shared >= ExactGrid::bottom ? shared : std::min(shared, grid_.spanning(largest));
  }

  [[nodiscard]] MortonKey address(std::uint32_t p, int base) const {
    const MortonKey code =
        encode({grid_.window(placed_.x[p], base), grid_.window(placed_.y[p], base)});
    const int level = std::min(grid_.spanning(placed_.reach[p]) - base, levels_at_a_time);
    return kernel::Addresses{}.of(code, level);
  }

  const SortedParticles& placed_;
  const ExactGrid& grid_;
  Unwritten<std::uint32_t> order_;
  Unwritten<MortonKey> keys_;
  int root_ = 0;
  std::vector<Crowd> waiting_;
  std::vector<OwnCell> cells_;
};

void rearrange(SortedParticles& placed, std::span<const std::uint32_t> order) {
  SortedParticles sorted;
  sorted.renew(placed.size);
  for (std::size_t k = 0; k < placed.size; ++k) {
    const std::uint32_t p = order[k];
    sorted.x[k] = placed.x[p], sorted.y[k] = placed.y[p];
    sorted.reach[k] = placed.reach[p], sorted.id[k] = placed.id[p];
  }
  placed = std::move(sorted);
}

// From the root down, level by level.
class DeepGrower {
 public:
  DeepGrower(const SortedParticles& placed, const ExactGrid& grid, DeepCells& made)
      : placed_(placed), grid_(grid), made_(made) {}

  void grow(int root, std::uint32_t few) {
    made_.cells.push_back({0, root, -1, {}, {0, static_cast<std::uint32_t>(made_.level.size())}});
    for (std::uint32_t c = 0; c < made_.cells.size(); ++c) {
      const auto [first, last] = made_.cells[c].points;
      const bool finer = made_.level[last - 1] > made_.cells[c].level;
      if (finer && made_.first[last] - made_.first[first] > few) split(c);
    }
  }

 private:
  // Its own and its ancestors' own cells on the same corner come first, and stay.
  void split(std::uint32_t c) {
    const Cell cell = made_.cells[c];
    Range rest = cell.points;
    while (made_.level[rest.first] <= cell.level) ++rest.first;
    const auto begin = static_cast<std::uint32_t>(made_.cells.size());
    for (unsigned quarter = 0; quarter < 4; ++quarter) {
      const std::uint32_t end = end_of(quarter, cell.level, rest);
      if (end == rest.first) continue;
      made_.cells.push_back(
          {quarter, cell.level + 1, static_cast<std::int32_t>(c), {}, {rest.first, end}});
      rest.first = end;
    }
    made_.cells[c].children = {begin, static_cast<std::uint32_t>(made_.cells.size())};
  }

  // The first own cell beyond a quarter of a cell of a level.
  [[nodiscard]] std::uint32_t end_of(unsigned quarter, int level, Range within) const {
    if (within.empty() || quarter_of(within.last - 1, level) <= quarter) return within.last;
    while (!within.empty()) {
      const std::uint32_t middle = within.first + within.size() / 2;
      (quarter_of(middle, level) <= quarter ? within.first : within.last) =
          quarter_of(middle, level) <= quarter ? middle + 1 : middle;
    }
    return within.first;
  }

  [[nodiscard]] unsigned quarter_of(std::uint32_t own, int level) const {
    const std::uint32_t p = made_.first[own];
    return grid_.half(placed_.x[p], level) | grid_.half(placed_.y[p], level) << 1;
  }

  const SortedParticles& placed_;
  const ExactGrid& grid_;
  DeepCells& made_;
};

}  // namespace

DeepCells deepen(SortedParticles& placed, std::uint32_t few) {
  DeepCells made;
  if (placed.size == 0) return made;
  const ExactGrid grid = grid_of(placed);
  Sorting sorting(placed, grid);
  for (const OwnCell& cell : sorting.sort()) {
    made.first.push_back(cell.first);
    made.level.push_back(cell.level);
  }
  rearrange(placed, sorting.order());
  made.first.push_back(static_cast<std::uint32_t>(placed.size));
  DeepGrower(placed, grid, made).grow(sorting.root(), few);
  for (int level = 0; level <= made.cells.back().level; ++level) {
    made.sides.push_back(grid.side(level));
  }
  return made;
}

bool too_shallow(const HomeCells& own, const SortedParticles& placed) {
  const double half = own.domain.cell_side(kernel::deepest_own) / 2;
  double looked_at = 0;
  for (std::size_t c = 0; c < own.size(); ++c) {
    if (own.level[c] != kernel::deepest_own || own.first[c + 1] - own.first[c] <= deep_crowd)
      continue;
    const auto fine = static_cast<double>(std::count_if(placed.reach.data() + own.first[c],
                                                        placed.reach.data() + own.first[c + 1],
                                                        [&](double r) { return r < half; }));
    looked_at += fine * fine;
  }
  return looked_at > deep_crowd * static_cast<double>(placed.size);
}

}  // namespace vortree::tree
