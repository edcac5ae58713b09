#include "tree/neighbors/ball_search.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "tree/base/parallel.hpp"
#include "tree/base/told.hpp"
#include "tree/base/tuning.hpp"
#include "tree/build/build_reverse.hpp"
#include "tree/build/split_rule.hpp"
#include "tree/neighbors/pair_rule.hpp"

// Compiled without fused operations: see tree/neighbors/pair_rule.hpp.
namespace vortree::tree {
namespace {

void check_count(std::size_t n) {
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  if (n <= most) return;
  throw std::invalid_argument("ball search: " + std::to_string(n) + " points; at most " +
                              std::to_string(most) + " can be listed");
}

void check_radius(std::span<const double> radius, std::size_t places) {
  if (radius.size() != places) {
    throw std::invalid_argument("ball search: " + std::to_string(radius.size()) + " radii, " +
                                std::to_string(places) + " places");
  }
  const auto fit = [](double r) { return std::isfinite(r) && r >= 0.0; };
  const auto unfit = std::ranges::find_if_not(radius, fit);
  if (unfit == radius.end()) return;
  throw std::invalid_argument("ball search: radius[" + std::to_string(unfit - radius.begin()) +
                              "] is " + told(*unfit) + "; it must be finite and >= 0");
}

// From a place to a point, and to the nearest that an interval may hold.
struct InPlane {
  double x, y;

  [[nodiscard]] double dx(double at) const { return at - x; }
  [[nodiscard]] double dy(double at) const { return at - y; }
  [[nodiscard]] double dx(double low, double high) const { return to_nearest(low, high, x); }
  [[nodiscard]] double dy(double low, double high) const { return to_nearest(low, high, y); }

  static double to_nearest(double low, double high, double place) {
    return low > place ? low - place : high < place ? high - place : 0.0;
  }
};

// The same of nearest images: min(d, L - d) is least at an end of the d that an interval allows.
struct InBox {
  double x, y;
  PeriodicBox period;

  [[nodiscard]] double dx(double at) const { return nearest_image(at - x, period.x); }
  [[nodiscard]] double dy(double at) const { return nearest_image(at - y, period.y); }
  [[nodiscard]] double dx(double low, double high) const {
    return to_nearest(low, high, x, period.x);
  }
  [[nodiscard]] double dy(double low, double high) const {
    return to_nearest(low, high, y, period.y);
  }

  static double to_nearest(double low, double high, double place, double period) {
    const double least = std::abs(InPlane::to_nearest(low, high, place));
    return std::min(least, period - std::max(high - place, place - low));
  }
};

using Found = std::vector<std::int32_t>;

void join(std::span<const Found> found, std::size_t places, PairList& rows) {
  std::int64_t before = 0;
  for (std::size_t i = 0; i < places; ++i) {
    const std::int64_t own = rows.start[i + 1];
    rows.start[i + 1] = before += own;
  }
  rows.make_room(before);
  std::int32_t* to = rows.index.data();
  for (const Found& some : found) to = std::ranges::copy(some, to).out;
}

}  // namespace

BallSearch::BallSearch(Points points, const PeriodicBox& box) : box_(box) {
  const Domain domain = enclose(points);
  check_count(points.size());
  check_inside(box, points);
  tree_ = build_reverse(morton_order(points, domain), crowded(ball_capacity));
  const auto order = tree_.order();
  const auto cells = tree_.cells();
  x_.renew(order.size()), y_.renew(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    x_[k] = points.x[order[k]], y_[k] = points.y[order[k]];
  }
  constexpr double far = std::numeric_limits<double>::infinity();
  boxes_.assign(cells.size(), {far, -far, far, -far});
  for (std::size_t c = cells.size(); c-- > 0;) {
    Box& box = boxes_[c];
    const auto widen = [&box](const Box& other) {
      box = {std::min(box.left, other.left), std::max(box.right, other.right),
             std::min(box.low, other.low), std::max(box.high, other.high)};
    };
    const Range children = cells[c].children, own = cells[c].points;
    for (std::uint32_t k = children.first; k < children.last; ++k) widen(boxes_[k]);
    if (!cells[c].childless()) continue;
    for (std::uint32_t k = own.first; k < own.last; ++k) widen({x_[k], x_[k], y_[k], y_[k]});
  }
}

template <class Distance>
void BallSearch::walk(const Distance& distance, double radius, Found& found) const {
  std::array<std::uint32_t, 4 * (max_level + 1)> waiting{0};
  std::size_t count = boxes_.empty() ? 0 : 1;
  while (count > 0) {
    const std::uint32_t c = waiting[--count];
    const Box& box = boxes_[c];
    const double dx = distance.dx(box.left, box.right), dy = distance.dy(box.low, box.high);
    if (!within<PairRule::own>(dx, dy, radius, radius)) continue;
    const Cell& cell = tree_.cells()[c];
    for (std::uint32_t k = cell.children.first; k < cell.children.last; ++k) waiting[count++] = k;
    if (!cell.childless()) continue;
    for (std::uint32_t k = cell.points.first; k < cell.points.last; ++k) {
      if (within<PairRule::own>(distance.dx(x_[k]), distance.dy(y_[k]), radius, radius)) {
        found.push_back(static_cast<std::int32_t>(tree_.order()[k]));
      }
    }
  }
}

void BallSearch::find(double x, double y, double radius, Found& found) const {
  if (!box_.periodic()) return walk(InPlane{x, y}, radius, found);
  walk(InBox{x, y, {period_of(box_.x), period_of(box_.y)}}, radius, found);
}

void BallSearch::list(Points places, std::span<const double> radius, PairList& rows) const {
  (void)enclose(places);
  const std::size_t n = places.size(), parts = (n + ball_portion - 1) / ball_portion;
  check_radius(radius, n);
  rows.start.renew(n + 1);
  rows.start[0] = 0;
  std::vector<Found> found(parts);
  std::atomic<std::int64_t> pairs = 0;
  for_each_piece(parts, [&](std::size_t p) {
    for (std::size_t i = p * ball_portion; i < std::min(n, (p + 1) * ball_portion); ++i) {
      const std::size_t before = found[p].size();
      const double x = image_in_box(places.x[i], box_.x), y = image_in_box(places.y[i], box_.y);
      find(x, y, radius[i], found[p]);
      std::sort(found[p].begin() + static_cast<std::ptrdiff_t>(before), found[p].end());
      rows.start[i + 1] = static_cast<std::int64_t>(found[p].size() - before);
    }
    pairs += static_cast<std::int64_t>(found[p].size());
    if (pairs > rows.most) rows.refuse(pairs);
  });
  join(found, n, rows);
}

}  // namespace vortree::tree
