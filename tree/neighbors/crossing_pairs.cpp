#include "tree/neighbors/crossing_pairs.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "tree/base/parallel.hpp"
#include "tree/base/tuning.hpp"
#include "tree/cells/home_cells.hpp"
#include "tree/neighbors/neighbors.hpp"

// Compiled without fused operations: see tree/neighbors/pair_rule.hpp.
namespace vortree::tree {
namespace {

void check(Points points, std::span<const double> reach, const PeriodicBox& box) {
  if (points.size() != reach.size()) {
    throw std::invalid_argument("neighbors: " + std::to_string(points.size()) + " points but " +
                                std::to_string(reach.size()) + " reaches");
  }
  check_particles(points, reach);
  check_inside(box, points);
}

// May something in [0, length) be within the reach of x across an edge? Two points x < x' are
// length - (x' - x) apart that way. Rounding hides nothing: x' - x <= x', which is rounded already,
// and length - x' is at least the spacing of doubles, of which rounding x' - x takes half.
bool goes_over(double x, double reach, double length) {
  return length != 0 && (x < reach || length - x < reach);
}

bool goes_over(double x, double y, double reach, const PeriodicBox& box) {
  return goes_over(x, reach, box.x) || goes_over(y, reach, box.y);
}

// Rows of the plane, with room behind each for as many as it gains.
PairList with_room(const PairList& rows, std::span<const std::int64_t> gained) {
  PairList wide;
  wide.most = rows.most;
  wide.start.renew(rows.size() + 1);
  wide.start[0] = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    wide.start[i + 1] = wide.start[i] + rows.start[i + 1] - rows.start[i] + gained[i];
  }
  wide.make_room(wide.start[rows.size()]);
  share_evenly(all_of(rows.size()), rows.size() > worth_sharing, [&](std::uint32_t i) {
    std::ranges::copy(rows.row(i), wide.index.data() + wide.start[i]);
  });
  return wide;
}

}  // namespace

CrossingPairs::CrossingPairs(Points points, std::span<const double> reach, const PeriodicBox& box)
    : period_{period_of(box.x), period_of(box.y)} {
  check(points, reach, box);
  if (!box.periodic() || reach.empty()) return;
  const double largest = std::ranges::max(reach);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points.x[i], y = points.y[i];
    if (!goes_over(x, y, largest, box)) continue;
    if (goes_over(x, y, reach[i], box)) {
      seekers_.push_back(static_cast<std::uint32_t>(x_.size()));
    }
    x_.push_back(x), y_.push_back(y), reach_.push_back(reach[i]);
    number_.push_back(static_cast<std::int32_t>(i));
  }
  if (!seekers_.empty()) near_edge_.emplace(Points{x_, y_}, box);
}

template <PairRule rule>
void CrossingPairs::seek(std::uint32_t seeker, std::vector<std::int32_t>& near,
                         Pairs& pairs) const {
  const std::size_t i = seeker;
  near.clear();
  near_edge_->find(x_[i], y_[i], reach_[i], near);
  std::ranges::sort(near);
  for (const std::int32_t found : near) {
    const auto j = static_cast<std::size_t>(found);
    const bool keeps =
        rule == PairRule::own || reach_[i] > reach_[j] || (reach_[i] == reach_[j] && i < j);
    const double dx = x_[j] - x_[i], dy = y_[j] - y_[i];
    if (!keeps || within<rule>(dx, dy, reach_[i], reach_[j])) continue;
    const double across_x = nearest_image(dx, period_.x), across_y = nearest_image(dy, period_.y);
    if (within<rule>(across_x, across_y, reach_[i], reach_[j])) {
      pairs.push_back({number_[i], number_[j]});
    }
  }
}

template <PairRule rule>
std::vector<CrossingPairs::Pairs> CrossingPairs::seek_all(const PairList& rows) const {
  const std::size_t n = seekers_.size(), parts = (n + ball_portion - 1) / ball_portion;
  std::vector<Pairs> pairs(parts);
  std::atomic<std::int64_t> count = static_cast<std::int64_t>(rows.index.size());
  for_each_piece(parts, [&](std::size_t p) {
    std::vector<std::int32_t> near;
    for (std::size_t k = p * ball_portion; k < std::min(n, (p + 1) * ball_portion); ++k) {
      seek<rule>(seekers_[k], near, pairs[p]);
    }
    count += static_cast<std::int64_t>(pairs[p].size());
    if (count > rows.most) rows.refuse(count);
  });
  return pairs;
}

void CrossingPairs::add_to(PairRule rule, Listing listing, PairList& rows) const {
  if (!near_edge_) return;
  const std::vector<Pairs> all = rule == PairRule::max    ? seek_all<PairRule::max>(rows)
                                 : rule == PairRule::mean ? seek_all<PairRule::mean>(rows)
                                                          : seek_all<PairRule::own>(rows);
  const bool both = listing == Listing::both_ways && rule != PairRule::own;
  std::vector<std::int64_t> gained(rows.size(), 0);
  for (const Pairs& pairs : all)
    for (const auto [i, j] : pairs) ++gained[i], gained[j] += both;
  PairList wide = with_room(rows, gained);
  const auto append = [&](std::int32_t i, std::int32_t j) {
    wide.index[static_cast<std::size_t>(wide.start[i + 1] - gained[i]--)] = j;
  };
  for (const Pairs& pairs : all)
    for (const auto [i, j] : pairs) {
      append(i, j);
      if (both) append(j, i);
    }
  rows = std::move(wide);
}

PairList neighbors(Points points, std::span<const double> reach, const PeriodicBox& box,
                   PairRule rule, Listing listing) {
  PairList rows = neighbors(points, reach, rule, listing);
  CrossingPairs(points, reach, box).add_to(rule, listing, rows);
  return rows;
}

}  // namespace vortree::tree
