#include "sph/neighbors/kept_list.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "neighbors/sort_rows.hpp"
#include "sph/neighbors/tuning.hpp"
#include "tree/neighbors/pair_rule.hpp"

// Compiled without fused operations: see tree/neighbors/pair_rule.hpp.
namespace vortree::sph {
namespace {

using tree::PairList;
using tree::PairRule;

/// Far more than rounding makes of lengths, in reaches.
constexpr double rounding = 0x1p-40;

bool near(tree::Points at, std::span<const double> reach, std::size_t i, std::size_t j) {
  return tree::within<PairRule::mean>(at.x[j] - at.x[i], at.y[j] - at.y[i], reach[i], reach[j]);
}

/// Rows of n particles: `show(i, take)` calls take(j) for each neighbor.
void write_rows(std::size_t n, const auto& show, PairList& rows) {
  rows.start.renew(n + 1);
  rows.start[0] = 0;
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    std::int64_t count = 0;
    show(i, [&](std::int32_t) { ++count; });
    rows.start[i + 1] = count;
  }
  for (std::size_t i = 0; i < n; ++i) rows.start[i + 1] += rows.start[i];
  rows.make_room(rows.start[n]);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    std::int32_t* next = rows.index.data() + rows.start[i];
    show(i, [&](std::int32_t j) { *next++ = j; });
  }
}

/// values[k] becomes what values[from[k]] was, or anything where there is none.
void rearrange(std::vector<double>& values, std::span<const std::int32_t> from) {
  std::vector<double> moved(from.size());
  for (std::size_t k = 0; k < from.size(); ++k)
    if (from[k] >= 0) moved[k] = values[static_cast<std::size_t>(from[k])];
  values = std::move(moved);
}

}  // namespace

void KeptList::renew(tree::Points points, std::span<const double> reach,
                     std::span<const std::int32_t> was, double skin, const Search& search,
                     PairList& rows) {
  find_anchors(points, reach, was);
  if (without_.size() > most_sought) {
    rebuild(points, reach, skin, search);
  } else if (!same_numbers()) {
    lay_anchors(points, reach, skin);
    seek();
    renumber();
  }
  narrow(points, reach, rows);
}

/// Who has a valid anchor, each of its own.
void KeptList::find_anchors(tree::Points points, std::span<const double> reach,
                            std::span<const std::int32_t> was) {
  from_.assign(points.size(), -1), to_.assign(x_.size(), -1), without_.clear();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto old = static_cast<std::size_t>(was[k]);
    const bool there = was[k] >= 0 && old < to_.size() && to_[old] < 0;
    const double wide = there ? reach_[old] : 0;
    if (there && reach[k] + 2 * std::hypot(points.x[k] - x_[old], points.y[k] - y_[old]) <=
                     wide - rounding * wide) {
      from_[k] = was[k], to_[old] = static_cast<std::int32_t>(k);
    } else {
      without_.push_back(static_cast<std::int32_t>(k));
    }
  }
}

bool KeptList::same_numbers() const {
  if (!without_.empty() || from_.size() != to_.size()) return false;
  for (std::size_t k = 0; k < from_.size(); ++k)
    if (from_[k] != static_cast<std::int32_t>(k)) return false;
  return true;
}

void KeptList::rebuild(tree::Points points, std::span<const double> reach, double skin,
                       const Search& search) {
  x_.assign(points.x.begin(), points.x.end()), y_.assign(points.y.begin(), points.y.end());
  reach_.assign(reach.begin(), reach.end());
  for (double& r : reach_) r *= 1 + skin;
  search({x_, y_}, reach_, list_);
  ++rebuilt_;
}

void KeptList::lay_anchors(tree::Points points, std::span<const double> reach, double skin) {
  for (auto* values : {&x_, &y_, &reach_}) rearrange(*values, from_);
  for (const std::int32_t number : without_) {
    const auto k = static_cast<std::size_t>(number);
    x_[k] = points.x[k], y_[k] = points.y[k], reach_[k] = (1 + skin) * reach[k];
  }
}

/// The pairs of those without a valid anchor before, from both sides.
void KeptList::seek() {
  found_.clear();
  for (const std::int32_t i : without_)
    for (std::int32_t j = 0; j < static_cast<std::int32_t>(x_.size()); ++j) {
      if (j == i || !near({x_, y_}, reach_, i, j)) continue;
      found_.push_back({i, j});
      if (from_[j] >= 0) found_.push_back({j, i});
    }
  std::ranges::sort(found_);
  sought_ += static_cast<long>(without_.size());
}

void KeptList::renumber() {
  const auto show = [&](std::size_t k, const auto& take) {
    if (from_[k] >= 0)
      for (const std::int32_t old : list_.row(static_cast<std::size_t>(from_[k])))
        if (to_[old] >= 0) take(to_[old]);
    const auto of = static_cast<std::int32_t>(k);
    auto one = std::ranges::lower_bound(found_, SoughtPair{of, 0});
    for (; one != found_.end() && one->of == of; ++one) take(one->neighbor);
  };
  write_rows(from_.size(), show, next_);
  std::swap(list_, next_);
  neighbors::sort_rows(list_);
}

void KeptList::narrow(tree::Points points, std::span<const double> reach, PairList& rows) const {
  const auto show = [&](std::size_t i, const auto& take) {
    for (const std::int32_t j : list_.row(i))
      if (near(points, reach, i, static_cast<std::size_t>(j))) take(j);
  };
  write_rows(points.size(), show, rows);
}

}  // namespace vortree::sph
