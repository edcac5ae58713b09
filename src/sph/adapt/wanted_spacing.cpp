#include "sph/adapt/wanted_spacing.hpp"

#include <utility>

namespace vortree::sph {

WantedSpacing::WantedSpacing(std::shared_ptr<const body::Shape> shape, double finest, int levels,
                             double zone, double growth)
    : shape_(std::move(shape)), distance_{zone}, spacing_{finest} {
  double width = zone;
  for (int level = 1; level < levels && shape_; ++level) {
    const double spacing = 2 * spacing_.back(), wider = growth * width + 2 * spacing;
    distance_.push_back((width + wider) / 2);
    spacing_.push_back(spacing);
    width = wider;
  }
}

double WantedSpacing::at(Vec2 at) const {
  if (spacing_.size() == 1 || shape_->beyond(at, distance_.back())) return spacing_.back();
  const double distance = shape_->distance(at);
  if (distance <= distance_.front()) return spacing_.front();
  std::size_t level = 1;
  while (level < distance_.size() && distance > distance_[level]) ++level;
  if (level == distance_.size()) return spacing_.back();
  const double share =
      (distance - distance_[level - 1]) / (distance_[level] - distance_[level - 1]);
  return (1 + share) * spacing_[level - 1];
}

}  // namespace vortree::sph
