#include "body/outlines/shape_group.hpp"

#include <algorithm>
#include <cmath>

namespace vortree::body {

WallPoint PlacedShape::nearest(Vec2 at) const {
  WallPoint found = shape_->nearest(back_(at - at_));
  found.normal = turn_(found.normal);
  return found;
}

std::vector<OutlinePoint> PlacedShape::trace() const {
  std::vector<OutlinePoint> all = shape_->trace();
  for (OutlinePoint& one : all) one.at = at_ + turn_(one.at);
  return all;
}

ShapeGroup::ShapeGroup(std::vector<std::shared_ptr<const Shape>> members)
    : members_(std::move(members)), first_arc_{0} {
  for (const auto& one : members_) first_arc_.push_back(first_arc_.back() + one->perimeter());
}

std::vector<double> ShapeGroup::perimeters() const {
  std::vector<double> all;
  for (const auto& one : members_) all.push_back(one->perimeter());
  return all;
}

Vec2 ShapeGroup::point(double arc) const {
  const auto after = std::upper_bound(first_arc_.begin() + 1, first_arc_.end() - 1, arc);
  const std::size_t k = after - first_arc_.begin() - 1;
  return members_[k]->point(arc - first_arc_[k]);
}

WallPoint ShapeGroup::nearest(Vec2 at) const {
  WallPoint best{0, INFINITY, {}, 0};
  for (std::size_t k = 0; k < members_.size(); ++k) {
    if (k > 0 && (best.distance <= 0 || members_[k]->beyond(at, best.distance))) continue;
    const WallPoint found = members_[k]->nearest(at);
    if (found.distance >= best.distance) continue;
    best = found;
    // Round-off must not carry an arc beyond where its curve begins or ends.
    best.arc = std::clamp(first_arc_[k] + found.arc, first_arc_[k],
                          std::nextafter(first_arc_[k + 1], 0.0));
  }
  return best;
}

double ShapeGroup::distance(Vec2 at) const {
  double least = INFINITY;
  for (const auto& one : members_)
    if (least == INFINITY || !one->beyond(at, least)) least = std::min(least, one->distance(at));
  return least;
}

bool ShapeGroup::beyond(Vec2 at, double d) const {
  return std::ranges::all_of(members_, [&](const auto& one) { return one->beyond(at, d); });
}

namespace {

/// The place of `a` between two arcs that is nearest to `b`, by the golden section.
double least_between(const Shape& a, const Shape& b, double low, double high) {
  constexpr double golden = 0.6180339887498949;
  const auto distance = [&](double arc) { return b.distance(a.point(arc)); };
  while (high - low > 1e-7 * a.perimeter()) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    if (distance(left) < distance(right))
      high = right;
    else
      low = left;
  }
  return distance((low + high) / 2);
}

/// From the places of one outline.
double least_from(const Shape& a, const Shape& b) {
  const std::vector<OutlinePoint> all = a.trace();
  const auto nearest = std::ranges::min_element(
      all, {}, [&](const OutlinePoint& one) { return b.distance(one.at); });
  const double around = a.perimeter() / 128;
  return std::min(b.distance(nearest->at),
                  least_between(a, b, nearest->arc - around, nearest->arc + around));
}

}  // namespace

double gap_between(const PlacedShape& a, const PlacedShape& b) {
  return std::min(least_from(a, b), least_from(b, a));
}

}  // namespace vortree::body
