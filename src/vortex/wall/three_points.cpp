#include "vortex/wall/three_points.hpp"

#include <algorithm>

#include "vortex/wall/tuning.hpp"

namespace vortree::vortex {
namespace {

/// The square of that by which arms may be stretched which reach so far across and along the wall:
/// it may bend towards them.
double most_stretched(double across, double along, const body::WallPoint& near) {
  const double room = (1 - nearest_of_mean) * near.distance;
  const double sag = 2 * std::max(-near.curvature, 0.0) * along * along;
  const double root = across + std::sqrt(across * across + sag * room);
  return root > 0 ? std::pow(2 * room / root, 2) : 1 / least_outer;
}

}  // namespace

ThreePoints::ThreePoints(const Deviator& deviator, const body::WallPoint& near) {
  const double size = deviator.size();
  if (size == 0 || !(near.distance > 0)) return;
  // Of two points, outer = 1: half the difference of |arm^2| and its part along the wall.
  const double across = std::sqrt(std::max(size + deviator.across(near.normal), 0.0)),
               along = std::sqrt(std::max(size - deviator.across(near.normal), 0.0));
  const double stretched = std::min(most_stretched(across, along, near), 1 / least_outer);
  outer = 1 / std::max(stretched, 1.0);
  arm_squared = {2 * stretched * deviator.xx, 2 * stretched * deviator.xy};
}

}  // namespace vortree::vortex
