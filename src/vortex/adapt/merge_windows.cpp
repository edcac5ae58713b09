#include "vortex/adapt/merge_windows.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

#include "vortex/adapt/merge_kernel.hpp"
#include "vortex/adapt/tuning.hpp"

namespace vortree::vortex {
namespace {

using merge_kernel::Limits;
using merge_kernel::MergeWindow;

constexpr int cells = cells_across * cells_across;  // of a tile

/// Place of each cell of a tile along a Hilbert curve.
constexpr std::array<std::uint8_t, cells> hilbert_curve() {
  std::array<std::uint8_t, cells> place{};
  for (int cell = 0; cell < cells; ++cell) {
    int x = cell % cells_across, y = cell / cells_across, along = 0;
    for (int s = cells_across / 2; s > 0; s /= 2) {
      const bool right = x & s, upper = y & s;
      along += s * s * ((3 * right) ^ upper);
      if (!upper) {
        if (right) {
          x = cells_across - 1 - x;
          y = cells_across - 1 - y;
        }
        std::swap(x, y);
      }
    }
    place[cell] = static_cast<std::uint8_t>(along);
  }
  return place;
}
constexpr auto curve = hilbert_curve();

/// Tiles of the plane, row by row, those of positive circulations first. Where a cloud is so thin
/// that there would be more tiles than some four a blob, far ones share a number.
class Tiling {
 public:
  Tiling(std::span<const AdaptedBlob> adapted, double side, double shift)
      : inverse_side_(1 / side), shift_(shift) {
    double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
#pragma omp parallel for schedule(static) reduction(min : x0, y0) reduction(max : x1, y1)
    for (const AdaptedBlob& p : adapted) {
      x0 = std::min(x0, p.x);
      x1 = std::max(x1, p.x);
      y0 = std::min(y0, upright(p));
      y1 = std::max(y1, upright(p));
    }
    x0_ = std::floor(along(x0));
    y0_ = std::floor(along(y0));
    columns_ = std::floor(along(x1)) - x0_ + 1;
    const double rows = std::floor(along(y1)) - y0_ + 1;
    most_ = std::min(columns_ * rows,
                     tiles_a_blob * static_cast<double>(adapted.size()) + tiles_anyway);
  }

  std::uint32_t size() const {
    return 2 * static_cast<std::uint32_t>(most_);
  }

  std::uint32_t tile(const AdaptedBlob& p) const {
    const double column = std::floor(along(p.x)) - x0_, row = std::floor(along(upright(p))) - y0_;
    double number = row * columns_ + column;
    if (!(number < most_)) number = std::isfinite(number) ? std::fmod(number, most_) : 0;
    return static_cast<std::uint32_t>(number) + (p.gamma < 0 ? size() / 2 : 0);
  }

  std::uint8_t place_in_tile(const AdaptedBlob& p) const {
    const double x = along(p.x), y = along(upright(p));
    const int column = static_cast<int>((x - std::floor(x)) * cells_across);
    const int row = static_cast<int>((y - std::floor(y)) * cells_across);
    return curve[(row & (cells_across - 1)) * cells_across + (column & (cells_across - 1))];
  }

 private:
  static double upright(const AdaptedBlob& p) {
    return p.gamma < 0 ? -p.y : p.y;
  }
  double along(double x) const {
    return x * inverse_side_ + shift_;
  }

  double inverse_side_, shift_, x0_, y0_, columns_, most_;
};

/// Blobs sorted by tile, stably, and where each tile's begin.
struct Tiled {
  Unwritten<AdaptedBlob> adapted;
  std::vector<std::uint32_t> first;
};

Tiled tiled(std::span<const AdaptedBlob> adapted, const Tiling& tiling) {
  const std::size_t n = adapted.size(), tiles = tiling.size(), teams = omp_get_max_threads();
  Tiled result{Unwritten<AdaptedBlob>(n), std::vector<std::uint32_t>(tiles + 1)};
  Unwritten<std::uint32_t> tile(n);
  std::vector<std::vector<std::uint32_t>> next(teams, std::vector<std::uint32_t>(tiles));
  const auto begin = [&](std::size_t team) { return n * team / teams; };
#pragma omp parallel for schedule(static, 1)
  for (std::size_t team = 0; team < teams; ++team)
    for (std::size_t i = begin(team); i < begin(team + 1); ++i)
      ++next[team][tile[i] = tiling.tile(adapted[i])];
  std::uint32_t sum = 0;
  for (std::size_t t = 0; t < tiles; ++t) {
    result.first[t] = sum;
    for (auto& team : next) sum += std::exchange(team[t], sum);
  }
  result.first[tiles] = sum;
#pragma omp parallel for schedule(static, 1)
  for (std::size_t team = 0; team < teams; ++team)
    for (std::size_t i = begin(team); i < begin(team + 1); ++i)
      result.adapted[next[team][tile[i]]++] = adapted[i];
  return result;
}

/// What one thread needs for a tile.
struct Desk {
  MergeWindow window;
  std::vector<std::uint32_t> order;
  std::vector<std::uint8_t> place;
  std::vector<AdaptedBlob> left;
};

/// Few are quickly sorted here; many, by the library.
void sort_few(std::span<std::uint32_t> numbers, auto less) {
  if (numbers.size() > few_to_sort) return std::sort(numbers.begin(), numbers.end(), less);
  for (std::size_t k = 1; k < numbers.size(); ++k)
    for (std::size_t i = k; i > 0 && less(numbers[i], numbers[i - 1]); --i)
      std::swap(numbers[i], numbers[i - 1]);
}

/// The blobs' numbers along the curve; within a cell by place, so that the order they come in does
/// not matter.
void sort_along_curve(std::span<const AdaptedBlob> adapted, const Tiling& tiling, Desk& desk) {
  const std::size_t n = adapted.size();
  desk.place.resize(n);
  std::array<std::uint32_t, cells + 1> next{};
  std::array<std::uint64_t, cells / 64> shared{};  // cells of several blobs, a bit each
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint8_t c = desk.place[i] = tiling.place_in_tile(adapted[i]);
    if (next[1 + c]++ > 0) shared[c / 64] |= std::uint64_t{1} << c % 64;
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::uint32_t i = 0; i < n; ++i) desk.order[next[desk.place[i]]++] = i;
  const auto less = [&](std::uint32_t a, std::uint32_t b) {
    return adapted[a].x != adapted[b].x ? adapted[a].x < adapted[b].x
                                        : std::abs(adapted[a].y) < std::abs(adapted[b].y);
  };
  // next[c] has become where cell c ends.
  for (std::uint32_t word = 0; word < shared.size(); ++word)
    for (std::uint64_t left = shared[word]; left != 0; left &= left - 1) {
      const std::uint32_t c = 64 * word + std::countr_zero(left), first = c > 0 ? next[c - 1] : 0;
      sort_few(std::span(desk.order).subspan(first, next[c] - first), less);
    }
}

/// Merges a tile's blobs and leaves what is left of them at its beginning.
std::uint32_t merge_tile(std::span<AdaptedBlob> adapted, std::span<AtWall> at_wall,
                         const Tiling& tiling, const Limits& limits, Desk& desk) {
  const std::size_t n = adapted.size(), windows = (n + MergeWindow::most - 1) / MergeWindow::most;
  desk.order.resize(n);
  std::iota(desk.order.begin(), desk.order.end(), 0u);
  if (windows > 1) sort_along_curve(adapted, tiling, desk);
  desk.left.clear();
  for (std::size_t w = 0; w < windows; ++w) {
    const std::size_t first = n * w / windows, last = n * (w + 1) / windows;
    const std::span members(&desk.order[first], last - first);
    const std::size_t left = desk.window.merge(members, adapted, at_wall, limits);
    for (std::uint32_t i : members.first(left)) desk.left.push_back(adapted[i]);
  }
  std::ranges::copy(desk.left, adapted.begin());
  return static_cast<std::uint32_t>(desk.left.size());
}

}  // namespace

void merge_in_windows(AdaptedBlobs& adapted, const Merging& merging, double shift) {
  const Tiling tiling(adapted.all, tile_side * merging.sigma_max, shift);
  const Limits limits(merging);
  Tiled sorted = tiled(adapted.all, tiling);
  const std::size_t tiles = tiling.size();
  std::vector<std::uint32_t> left(tiles + 1);
#pragma omp parallel
  {
    Desk desk;
#pragma omp for schedule(dynamic, tiles_a_turn)
    for (std::size_t t = 0; t < tiles; ++t) {
      const std::uint32_t first = sorted.first[t], count = sorted.first[t + 1] - first;
      if (count > 0)
        left[t + 1] =
            merge_tile({&sorted.adapted[first], count}, adapted.at_wall, tiling, limits, desk);
    }
  }
  std::partial_sum(left.begin(), left.end(), left.begin());
  adapted.all.resize(left[tiles]);
#pragma omp parallel for schedule(dynamic, moved_tiles_a_turn)
  for (std::size_t t = 0; t < tiles; ++t)
    std::copy_n(sorted.adapted.begin() + sorted.first[t], left[t + 1] - left[t],
                adapted.all.begin() + left[t]);
}

}  // namespace vortree::vortex
