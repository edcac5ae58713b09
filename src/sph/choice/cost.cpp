#include "sph/choice/cost.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "body/extent.hpp"
#include "body/shapes/circle.hpp"
#include "sph/adapt/wanted_spacing.hpp"

namespace vortree::sph {

double expected_particles(const SphCase& scene) {
  const SphSettings& own = scene.sph;
  const double perimeter = body::perimeter_of(*scene.body);
  const double radius = perimeter / (2 * std::numbers::pi);
  const WantedSpacing wanted(body::circle({}, radius), own.spacing, own.levels, own.zone,
                             own.growth);
  const auto [x0, y0, x1, y1] = *own.box;
  const double outermost = std::sqrt((x1 - x0) * (y1 - y0) / std::numbers::pi);
  constexpr int pieces = 1000;
  double particles = 0;
  for (int k = 0; k < pieces; ++k) {
    const double r = radius * std::pow(outermost / radius, (k + 0.5) / pieces);
    const double s = wanted.at({r, 0});
    particles += 2 * std::numbers::pi * r * r * std::log(outermost / radius) / pieces / (s * s);
  }
  return particles;
}

}  // namespace vortree::sph
