#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "neighbors/methods.hpp"
#include "tree/neighbors/pair_search.hpp"

namespace vortree::neighbors {
namespace {

using tree::PairRule;
using tree::Range;

// Finer levels are not told apart.
constexpr int most_levels = 24;

// Cells in rows over the box that some particles fill; those of a cell are one range.
struct Grid {
  double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY, largest = 0;
  double side = 1;
  int columns = 0, rows = 0;
  std::size_t count = 0;
  std::vector<std::uint32_t> first;  // of each cell, and the end

  void include(double x, double y, double reach) {
    left = std::min(left, x), right = std::max(right, x);
    low = std::min(low, y), high = std::max(high, y);
    largest = std::max(largest, reach);
    ++count;
  }

  // Cells as wide as the largest reach, but not many more than particles.
  void lay_cells() {
    const double width = right - left, height = high - low, extent = std::max(width, height);
    const double n = static_cast<double>(count);
    const double roomy = std::sqrt(width) * std::sqrt(height) / std::sqrt(n) / 2;
    side = std::max({largest * (1 + 1e-9), roomy, extent / n, extent * 1e-9, 1e-300});
    columns = count == 0 ? 0 : column(right) + 1;
    rows = count == 0 ? 0 : row(high) + 1;
    first.assign(static_cast<std::size_t>(columns) * rows + 1, 0);
  }

  [[nodiscard]] int column(double x) const { return static_cast<int>((x - left) / side); }
  [[nodiscard]] int row(double y) const { return static_cast<int>((y - low) / side); }
  [[nodiscard]] std::uint32_t cell(double x, double y) const {
    return static_cast<std::uint32_t>(row(y)) * columns + column(x);
  }

  // The runs of particles that may be within `reach` of a box. Rounding is monotone: nobody who is
  // within it along either axis is left out for the sake of the last bit.
  void name(double x0, double x1, double y0, double y1, double reach,
            std::vector<Range>& runs) const {
    const double r = reach;
    if (count == 0 || x1 + r < left || x0 - r > right || y1 + r < low || y0 - r > high) return;
    const int c0 = x0 - r <= left ? 0 : column(x0 - r);
    const int c1 = x1 + r >= right ? columns - 1 : column(x1 + r);
    const int r0 = y0 - r <= low ? 0 : row(y0 - r);
    const int r1 = y1 + r >= high ? rows - 1 : row(y1 + r);
    for (int y = r0; y <= r1; ++y) {
      const std::size_t begin = static_cast<std::size_t>(y) * columns;
      runs.push_back({first[begin + c0], first[begin + c1 + 1]});
    }
  }
};

// A grid for each level, from the coarsest on; the particles of one level after those of another.
class LevelGrids : public NeighborMethod {
 public:
  explicit LevelGrids(int levels) : levels_(levels) {}

  void build(const NeighborJob& job) override {
    grids_.assign(levels_, {});
    find_levels(job);
    std::uint32_t before = 0;
    for (Grid& grid : grids_) {
      grid.lay_cells();
    }
    for (std::size_t i = 0; i < level_.size(); ++i) {
      Grid& grid = grids_[level_[i]];
      ++grid.first[cell_[i] = grid.cell(job.points.x[i], job.points.y[i])];
    }
    for (Grid& grid : grids_) {
      for (std::uint32_t& first : grid.first) before += std::exchange(first, before);
    }
    fill(job);
    make_groups();
  }

  void search(const NeighborJob& job, tree::PairList& rows) override {
    search_.list(
        placed_, groups_,
        [&](const tree::Group& group, std::vector<Range>& others) { name(job, group, others); },
        job.rule, job.listing, rows);
  }

 private:
  void find_levels(const NeighborJob& job) {
    const std::size_t n = job.points.size();
    const double largest = n == 0 ? 0 : std::ranges::max(job.reach);
    level_.resize(n), cell_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double reach = job.reach[i];
      // Half of the largest reach is the first of the next level.
      const int halvings =
          reach > 0 ? std::min(std::ilogb(largest / reach * (1 + 1e-9)), levels_ - 1) : levels_ - 1;
      level_[i] = static_cast<std::uint8_t>(halvings);
      grids_[halvings].include(job.points.x[i], job.points.y[i], reach);
    }
  }

  // Moves the particles to their cells; afterwards first[c] is again where cell c begins.
  void fill(const NeighborJob& job) {
    placed_.renew(level_.size());
    for (std::size_t i = 0; i < level_.size(); ++i) {
      const std::uint32_t place = grids_[level_[i]].first[cell_[i]]++;
      placed_.x[place] = job.points.x[i];
      placed_.y[place] = job.points.y[i];
      placed_.reach[place] = job.reach[i];
      placed_.id[place] = static_cast<std::int32_t>(i);
    }
    std::uint32_t begin = 0;
    for (Grid& grid : grids_) {
      for (std::size_t c = 0; c + 1 < grid.first.size(); ++c) std::swap(grid.first[c], begin);
      begin = grid.first.back();
    }
  }

  void make_groups() {
    groups_.clear();
    for (std::uint32_t level = 0; level < grids_.size(); ++level) {
      const Grid& grid = grids_[level];
      for (std::size_t c = 0; c + 1 < grid.first.size(); ++c) {
        for (std::uint32_t p = grid.first[c]; p < grid.first[c + 1]; p += largest_group) {
          groups_.push_back(
              {{p, std::min(p + largest_group, grid.first[c + 1])}, level, grid.side});
        }
      }
    }
  }

  void name(const NeighborJob& job, const tree::Group& group, std::vector<Range>& others) const {
    double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY, largest = 0;
    for (std::uint32_t p = group.own.first; p < group.own.last; ++p) {
      x0 = std::min(x0, placed_.x[p]), x1 = std::max(x1, placed_.x[p]);
      y0 = std::min(y0, placed_.y[p]), y1 = std::max(y1, placed_.y[p]);
      largest = std::max(largest, placed_.reach[p]);
    }
    const bool once = job.listing == tree::Listing::once;
    for (std::uint32_t level = once ? group.cell : 0; level < grids_.size(); ++level) {
      const Grid& grid = grids_[level];
      const double reach = job.rule == PairRule::max    ? std::max(largest, grid.largest)
                           : job.rule == PairRule::mean ? (largest + grid.largest) / 2
                                                        : largest;
      const std::size_t begin = others.size();
      grid.name(x0, x1, y0, y1, reach, others);
      if (level == group.cell) leave_out_own(group.own, once, begin, others);
    }
  }

  // Of the runs of its own level a group leaves out itself, and for each pair once what is before.
  static void leave_out_own(Range own, bool once, std::size_t begin, std::vector<Range>& runs) {
    const std::size_t end = runs.size();
    for (std::size_t k = begin; k < end; ++k) {
      const Range run = runs[k];
      const Range behind{std::max(run.first, own.last), std::max(run.last, own.last)};
      const Range before{std::min(run.first, own.first), std::min(run.last, own.first)};
      runs[k] = behind;
      if (!once) runs.push_back(before);
    }
  }

  static constexpr std::uint32_t largest_group = 64;

  int levels_;
  std::vector<Grid> grids_;
  std::vector<std::uint8_t> level_;
  std::vector<std::uint32_t> cell_;
  tree::SortedParticles placed_;
  std::vector<tree::Group> groups_;
  tree::RowSearch search_;
};

}  // namespace

std::unique_ptr<NeighborMethod> make_level_grids() {
  return std::make_unique<LevelGrids>(most_levels);
}

std::unique_ptr<NeighborMethod> make_uniform_grid() {
  return std::make_unique<LevelGrids>(1);
}

}  // namespace vortree::neighbors
