#include "vortex/blobs/moments.hpp"

#include <cmath>

#include "vortex/cores/folded_core.hpp"

namespace vortree::vortex {
namespace {

struct Half {
  double gamma = 0;
  Vec2 moment;

  Vec2 centre() const { return gamma != 0 ? (1 / gamma) * moment : Vec2{}; }
};

Vec2 quadrupole_about(Vec2 centre, const Blobs& blobs) {
  Vec2 sum;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const Vec2 d = blobs.centre(i) - centre;
    const Deviator own = blobs.core(i).deviator;
    sum =
        sum + blobs.gamma[i] * Vec2{d.x * d.x - d.y * d.y + 2 * own.xx, 2 * d.x * d.y + 2 * own.xy};
  }
  return sum;
}

/// A Gaussian's mean distance from a line is that of one folded along it.
double mean_distance(Vec2 centre, Vec2 axis, const Blobs& blobs, double gamma) {
  double sum = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const double away = std::abs(dot(axis, blobs.centre(i) - centre));
    const double wide = std::sqrt(2 * blobs.core(i).covariance(axis).nn);
    sum += blobs.gamma[i] * folded::mean_distance(away, wide, 0);
  }
  return sum / gamma;
}

}  // namespace

Moments moments(const Blobs& blobs) {
  Half plus, minus;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    Half& half = blobs.gamma[i] > 0 ? plus : minus;
    half.gamma += blobs.gamma[i];
    half.moment = half.moment + blobs.gamma[i] * blobs.centre(i);
  }
  const double gamma = plus.gamma + minus.gamma;
  Moments result{plus.gamma, plus.centre(), {}, 0};
  if (std::abs(gamma) <= 1e-6 * (plus.gamma - minus.gamma)) {
    const Vec2 apart = plus.centre() - minus.centre();
    result.separation = std::sqrt(dot(apart, apart));
    result.quadrupole = quadrupole_about(0.5 * (plus.centre() + minus.centre()), blobs);
    return result;
  }
  const Vec2 centre = (1 / gamma) * (plus.moment + minus.moment);
  result.quadrupole = quadrupole_about(centre, blobs);
  const double tilt = 0.5 * std::atan2(result.quadrupole.y, result.quadrupole.x);
  result.separation = 2 * mean_distance(centre, {std::cos(tilt), std::sin(tilt)}, blobs, gamma);
  return result;
}

}  // namespace vortree::vortex
