#include "vortex/merge_close.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vortex/folded_core.hpp"

namespace vortree::vortex {
namespace {

constexpr std::int64_t none = -1;

/// Blobs binned by square cells, sorted by cell; rows of cells are contiguous.
class Bins {
 public:
  Bins(const Blobs& blobs, double side) : side_(side) {
    const auto [x0, x1] = std::minmax_element(blobs.x.begin(), blobs.x.end());
    const auto [y0, y1] = std::minmax_element(blobs.y.begin(), blobs.y.end());
    x0_ = *x0;
    y0_ = *y0;
    // A far straggler must not cost memory: cells are as many as blobs, at most a few times.
    const double most = 4.0 * static_cast<double>(blobs.size()) + 64;
    side_ = std::max({side_, std::sqrt((*x1 - x0_) * (*y1 - y0_) / most), (*x1 - x0_) / most,
                      (*y1 - y0_) / most});
    nx_ = static_cast<std::int64_t>((*x1 - x0_) / side_) + 1;
    ny_ = static_cast<std::int64_t>((*y1 - y0_) / side_) + 1;
    start_.assign(nx_ * ny_ + 1, 0);
    for (std::size_t i = 0; i < blobs.size(); ++i) ++start_[cell(blobs.centre(i)) + 1];
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    member_.resize(blobs.size());
    auto next = start_;
    for (std::size_t i = 0; i < blobs.size(); ++i)
      member_[next[cell(blobs.centre(i))]++] = static_cast<std::int64_t>(i);
  }

  /// Blob numbers in Morton-free row order: neighbors in space are neighbors in memory.
  const std::vector<std::int64_t>& members() const { return member_; }

  /// Calls use(k) with the positions k in members() of all within `side` of the point.
  template <class Use>
  void near(Vec2 at, Use use) const {
    const std::int64_t ix = column(at.x), iy = row(at.y);
    const std::int64_t left = std::max<std::int64_t>(ix - 1, 0), right = std::min(ix + 1, nx_ - 1);
    for (std::int64_t r = std::max<std::int64_t>(iy - 1, 0); r <= std::min(iy + 1, ny_ - 1); ++r)
      for (std::int64_t k = start_[r * nx_ + left]; k < start_[r * nx_ + right + 1]; ++k) use(k);
  }

 private:
  std::int64_t column(double x) const {
    return std::min(static_cast<std::int64_t>((x - x0_) / side_), nx_ - 1);
  }
  std::int64_t row(double y) const {
    return std::min(static_cast<std::int64_t>((y - y0_) / side_), ny_ - 1);
  }
  std::int64_t cell(Vec2 at) const { return row(at.y) * nx_ + column(at.x); }

  double side_, x0_, y0_;
  std::int64_t nx_, ny_;
  std::vector<std::int64_t> start_, member_;
};

Blobs reordered(const Blobs& blobs, const std::vector<std::int64_t>& order) {
  Blobs result;
  result.reserve(blobs.size());
  for (std::int64_t i : order) result.append(blobs.centre(i), blobs.gamma[i], blobs.sigma[i]);
  return result;
}

/// Error of merging i and j, or infinity where it is not allowed. Symmetric in i and j.
double merger_error(const Blobs& b, std::size_t i, std::size_t j, const Merging& merging) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const double gi = b.gamma[i], gj = b.gamma[j];
  if (gi * gj <= 0) return never;
  const double dx = b.x[i] - b.x[j], dy = b.y[i] - b.y[j];
  const double si = b.sigma[i] * b.sigma[i], sj = b.sigma[j] * b.sigma[j];
  const double d2 = dx * dx + dy * dy, least = std::min(si, sj);
  if (d2 > merging.reach * merging.reach * least) return never;
  const double reduced = std::abs(gi * gj / (gi + gj));
  const double error = reduced * (d2 + std::abs(si - sj)) / (least * std::sqrt(least));
  if (error > merging.tolerance) return never;
  const double w = gi / (gi + gj);
  const double wide = w * si + (1 - w) * sj + w * (1 - w) * d2;
  return wide > merging.sigma_max * merging.sigma_max ? never : error;
}

std::vector<std::int64_t> best_partners(const Blobs& blobs, const Bins& bins,
                                        const Merging& merging) {
  std::vector<std::int64_t> best(blobs.size(), none);
  const auto n = static_cast<std::int64_t>(blobs.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t i = 0; i < n; ++i) {
    double least = std::numeric_limits<double>::infinity();
    bins.near(blobs.centre(i), [&](std::int64_t j) {
      if (j == i) return;
      const double error = merger_error(blobs, i, j, merging);
      if (error < least) {
        least = error;
        best[i] = j;
      }
    });
  }
  return best;
}

/// Blob i of the merged pair (i, j).
void merge(Blobs& b, std::size_t i, std::size_t j, const Shape* wall) {
  const double gamma = b.gamma[i] + b.gamma[j], w = b.gamma[i] / gamma;
  const double mean_square =
      w * b.sigma[i] * b.sigma[i] + (1 - w) * b.sigma[j] * b.sigma[j];
  const Vec2 apart = b.centre(i) - b.centre(j);
  Placed merged{w * b.centre(i) + (1 - w) * b.centre(j),
                std::sqrt(mean_square + w * (1 - w) * dot(apart, apart))};
  const WallPoint at = wall ? wall->nearest(merged.centre) : WallPoint{};
  if (wall && folded::applies(at.distance, 2 * merged.sigma)) {
    const double across = wall->nearest(b.centre(i)).distance - wall->nearest(b.centre(j)).distance;
    const Vec2 mean = w * acting_position(b.centre(i), b.sigma[i], wall) +
                      (1 - w) * acting_position(b.centre(j), b.sigma[j], wall);
    merged = place(mean, std::sqrt(mean_square + 2 * w * (1 - w) * across * across), wall);
  }
  b.x[i] = merged.centre.x;
  b.y[i] = merged.centre.y;
  b.gamma[i] = gamma;
  b.sigma[i] = merged.sigma;
}

}  // namespace

void merge_close(Blobs& blobs, const Merging& merging, const Shape* wall) {
  if (merging.tolerance <= 0) return;
  for (int round = 0; round < merging.rounds && blobs.size() > 1; ++round) {
    const double widest = *std::max_element(blobs.sigma.begin(), blobs.sigma.end());
    const double side = merging.reach * std::min(widest, merging.sigma_max);
    blobs = reordered(blobs, Bins(blobs, side).members());
    const std::vector<std::int64_t> best = best_partners(blobs, Bins(blobs, side), merging);
    Blobs kept;
    kept.reserve(blobs.size());
    bool any = false;
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(blobs.size()); ++i) {
      const std::int64_t j = best[i];
      const bool mutual = j != none && best[j] == i;
      if (mutual && j < i) continue;
      if (mutual) merge(blobs, i, j, wall);
      any |= mutual;
      kept.append(blobs.centre(i), blobs.gamma[i], blobs.sigma[i]);
    }
    blobs = std::move(kept);
    if (!any) break;
  }
}

}  // namespace vortree::vortex
