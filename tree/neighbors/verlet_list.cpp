#include "tree/neighbors/verlet_list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "tree/base/told.hpp"

// Compiled without fused operations: see pair_rule.hpp.
namespace vortree::tree {

namespace {

// How far a particle may move, in reaches: less than half the skin by more than rounding can make
// of moves (some 2^-52 of themselves), and of the distances and reaches of the rule (2^-51 of a
// reach, then and now), however thin the skin is.
double may_move(double skin) {
  return std::max(0.0, skin / 2 * (1 - 0x1p-30) - 0x1p-48);
}

// The squares may overflow or underflow.
bool stays(double dx, double dy, double far) {
  return (dx == 0 && dy == 0) || within<PairRule::own>(dx, dy, far, 0);
}

template <PairRule rule>
void keep_neighbors(Points p, std::span<const double> reach, const PairList& all, PairList& rows) {
  const auto is_near = [&](std::size_t i, std::int32_t number) {
    const auto j = static_cast<std::size_t>(number);
    return within<rule>(p.x[j] - p.x[i], p.y[j] - p.y[i], reach[i], reach[j]);
  };
  rows.start.renew(all.size() + 1);
  rows.start[0] = 0;
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < all.size(); ++i) {
    rows.start[i + 1] =
        std::ranges::count_if(all.row(i), [&](std::int32_t j) { return is_near(i, j); });
  }
  for (std::size_t i = 0; i < all.size(); ++i) rows.start[i + 1] += rows.start[i];
  rows.index.renew(static_cast<std::size_t>(rows.start[all.size()]));
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::ranges::copy_if(all.row(i), rows.index.data() + rows.start[i],
                         [&](std::int32_t j) { return is_near(i, j); });
  }
}

}  // namespace

VerletList::VerletList(PairRule rule, Listing listing, double skin)
    : rule_(rule), listing_(listing), skin_(skin) {
  if (skin >= 0 && std::isfinite(skin)) return;
  throw std::invalid_argument("VerletList: skin is " + told(skin) + "; it must be finite and >= 0");
}

bool VerletList::outdated(Points points, std::span<const double> reach) const {
  if (points.x.size() != points.y.size() || reach.size() != points.size()) {
    throw std::invalid_argument("VerletList: " + std::to_string(points.x.size()) + " x, " +
                                std::to_string(points.y.size()) + " y, " +
                                std::to_string(reach.size()) + " reaches");
  }
  if (!built_ || points.size() != x_.size()) return true;
  const double least = reach.empty() ? 0 : std::ranges::min(reach);
  const double may = may_move(skin_);
  bool outdated = false;
  for (std::size_t k = 0; k < x_.size(); ++k) {
    const double far = may * (rule_ == PairRule::own ? least : reach[k]);
    // Not "moved too far" but "stays": NaN is outdated, too.
    outdated |= !stays(points.x[k] - x_[k], points.y[k] - y_[k], far) | !(reach[k] <= reach_[k]);
  }
  return outdated;
}

void VerletList::rebuild(Points points, std::span<const double> reach) {
  built_ = false;
  wide_.assign(reach.begin(), reach.end());
  // No particles are as far apart as the largest double.
  for (double& r : wide_) {
    if (std::isfinite(r)) r = std::min(r * (1 + skin_), std::numeric_limits<double>::max());
  }
  search_.place(points, wide_);
  search_.list(rule_, listing_, rows_);
  x_.assign(points.x.begin(), points.x.end());
  y_.assign(points.y.begin(), points.y.end());
  reach_.assign(reach.begin(), reach.end());
  built_ = true;
}

void VerletList::narrow(Points points, std::span<const double> reach, PairList& rows) const {
  switch (rule_) {
    case PairRule::max:
      return keep_neighbors<PairRule::max>(points, reach, rows_, rows);
    case PairRule::mean:
      return keep_neighbors<PairRule::mean>(points, reach, rows_, rows);
    default:
      return keep_neighbors<PairRule::own>(points, reach, rows_, rows);
  }
}

}  // namespace vortree::tree
