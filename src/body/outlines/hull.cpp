#include "body/outlines/hull.hpp"

#include <cmath>
#include <numbers>

#include "tree/base/simd.hpp"

namespace vortree::body {
namespace {

using std::numbers::pi;

Vec2 direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// The direction in which the curve is thinnest, to a few degrees.
double thinnest(const std::function<double(Vec2)>& support) {
  constexpr int tried = 32;
  double best = 0, least = INFINITY;
  for (int k = 0; k < tried; ++k) {
    const double angle = pi * k / tried;
    const double width = support(direction(angle)) + support(direction(angle + pi));
    if (width >= least) continue;
    least = width;
    best = angle;
  }
  return best;
}

}  // namespace

Hull::Hull(Vec2 centre, const std::function<double(Vec2)>& support) : centre_(centre) {
  // Directions a little shorter than 1 keep round-off on the safe side.
  constexpr double shorter = 1 - 0x1p-50;
  const double start = thinnest(support);
  for (int k = 0; k < sides; ++k) {
    const Vec2 along = direction(start + 2 * pi * k / sides);
    x_[k] = shorter * along.x;
    y_[k] = shorter * along.y;
    reach_[k] = support(along);
  }
}

bool Hull::beyond(Vec2 at, double d) const {
  const Lanes px = fill(at.x - centre_.x), py = fill(at.y - centre_.y);
  Lanes most = fill(-1e300);
  for (int k = 0; k < sides; k += lane_count)
    most = larger(most, px * load(&x_[k]) + py * load(&y_[k]) - load(&reach_[k]));
  return largest(most) > d;
}

}  // namespace vortree::body
