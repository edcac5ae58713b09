#include "sph/adapt/wanted_spacing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "sph/adapt/tuning.hpp"

namespace vortree::sph {

Widening::Widening(double finest, double coarsest, double zone, double growth)
    : coarsest_(coarsest), distance_{zone}, spacing_{finest} {
  const bool several = coarsest > 2 * finest * (1 + 1e-9);
  double width = zone;
  while (spacing_.back() < coarsest) {
    const double spacing = 2 * spacing_.back(), wider = growth * width + 2 * spacing;
    const double near = several ? distance_.back() + spacing_.back() / steepest : 0;
    distance_.push_back(std::max((width + wider) / 2, near));
    spacing_.push_back(spacing);
    width = wider;
  }
}

double Widening::at(double distance) const {
  if (distance <= distance_.front()) return spacing_.front();
  std::size_t level = 1;
  while (level < distance_.size() && distance > distance_[level]) ++level;
  if (level == distance_.size()) return coarsest_;
  const double share =
      (distance - distance_[level - 1]) / (distance_[level] - distance_[level - 1]);
  return std::min((1 + share) * spacing_[level - 1], coarsest_);
}

WantedSpacing::WantedSpacing(std::shared_ptr<const body::Shape> shape, double finest, int levels,
                             double zone, double growth, double period)
    : coarsest_(finest * std::exp2(levels - 1)), growth_(growth), period_(period) {
  if (shape && levels > 1) wishes_.push_back({std::move(shape), {finest, coarsest_, zone, growth}});
}

void WantedSpacing::add_ellipse(Vec2 centre, std::array<double, 2> half_axes, double angle,
                                double spacing) {
  const auto [a, b] = half_axes;
  wishes_.push_back({a == b ? body::circle(centre, a) : body::ellipse(centre, a, b, -angle),
                     {spacing, coarsest_, 0, growth_}});
}

double WantedSpacing::at(Vec2 at) const {
  if (period_ == 0) return nearest(at);
  double least = coarsest_;
  for (const double x : {-period_, 0.0, period_})
    for (const double y : {-period_, 0.0, period_})
      least = std::min(least, nearest(at + Vec2{x, y}));
  return least;
}

double WantedSpacing::nearest(Vec2 at) const {
  double least = coarsest_;
  for (const auto& [shape, widening] : wishes_)
    if (!shape->beyond(at, widening.end()))
      least = std::min(least, widening.at(shape->distance(at)));
  return least;
}

double WantedSpacing::finest() const {
  double least = coarsest_;
  for (const Wish& wish : wishes_) least = std::min(least, wish.widening.finest());
  return least;
}

}  // namespace vortree::sph
