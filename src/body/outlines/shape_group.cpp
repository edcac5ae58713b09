#include "body/outlines/shape_group.hpp"

#include <algorithm>
#include <cmath>

#include "body/outlines/greatest.hpp"

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

std::size_t ShapeGroup::curve_at(double arc) const {
  return std::upper_bound(first_arc_.begin() + 1, first_arc_.end() - 1, arc) - first_arc_.begin() -
         1;
}

Vec2 ShapeGroup::point(double arc) const {
  const std::size_t k = curve_at(arc);
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

/// From the places of one outline.
double least_from(const Shape& a, const Shape& b) {
  return -greatest(a, a.trace(), [&](Vec2 at) { return -b.distance(at); });
}

}  // namespace

double gap_between(const PlacedShape& a, const PlacedShape& b) {
  return std::min(least_from(a, b), least_from(b, a));
}

}  // namespace vortree::body
