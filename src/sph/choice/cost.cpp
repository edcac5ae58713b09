#include "sph/choice/cost.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/extent.hpp"
#include "body/shapes/circle.hpp"
#include "body/shapes/shapes.hpp"
#include "sph/adapt/wanted_spacing.hpp"
#include "sph/boundary/wall_nodes.hpp"

namespace vortree::sph {
namespace {

double radius_of(const body::BodySettings& body) {
  return body::perimeter_of(body) / (2 * std::numbers::pi);
}

WantedSpacing wanted_of(const SphCase& scene) {
  const SphSettings& own = scene.sph;
  return {body::circle({}, radius_of(*scene.body)), own.spacing, own.levels, own.zone, own.growth};
}

}  // namespace

double spacing_at_box(const SphCase& scene) {
  const auto [x0, y0, x1, y1] = *scene.sph.box;
  const auto [x, y] = scene.body->centre;
  const double nearest = std::min({x - x0, x1 - x, y - y0, y1 - y});
  return wanted_of(scene).at({nearest, 0});
}

double thickness_of(const body::BodySettings& body) {
  return area_of(*body::outline_of(body)) / body::length_of(body);
}

double expected_particles(const SphCase& scene) {
  const SphSettings& own = scene.sph;
  const double radius = radius_of(*scene.body);
  const WantedSpacing wanted = wanted_of(scene);
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
