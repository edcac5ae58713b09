#include "sph/choice/cost.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/extent.hpp"
#include "body/shapes/circle.hpp"
#include "body/shapes/shapes.hpp"
#include "sph/adapt/wanted_spacing.hpp"
#include "sph/boundary/outer_box.hpp"
#include "sph/boundary/wall_nodes.hpp"
#include "sph/setup.hpp"

namespace vortree::sph {
namespace {

double radius_of(const body::BodySettings& body) {
  return body::perimeter_of(body) / (2 * std::numbers::pi);
}

WantedSpacing beside_body(const SphCase& scene) {
  const SphSettings& own = scene.sph;
  return {body::circle({}, radius_of(*scene.body)), own.spacing, own.levels, own.zone, own.growth};
}

}  // namespace

double spacing_at_box(const SphCase& scene) {
  const auto [x0, y0, x1, y1] = *scene.sph.box;
  const auto [x, y] = scene.body->centre;
  const double nearest = std::min({x - x0, x1 - x, y - y0, y1 - y});
  return beside_body(scene).at({nearest, 0});
}

double extent_of(const body::BodySettings& body) {
  const auto [half_x, half_y] = body::half_extent(body);
  return std::max({body::length_of(body), 2 * half_x, 2 * half_y});
}

double thickness_of(const body::BodySettings& body) {
  return area_of(*body::outline_of(body)) / body::length_of(body);
}

double spacing_by_regions_at_box(const SphCase& scene) {
  const WantedSpacing wanted = wanted_of(scene.sph, nullptr, {});
  const auto [x0, y0, x1, y1] = *scene.sph.box;
  double least = wanted.coarsest();
  for (const BoundaryNode& node : box_nodes({{x0, y0}, {x1, y1}}, wanted.coarsest()))
    least = std::min(least, wanted.at(node.at));
  return least;
}

namespace {

/// The integral of 1/s^2 - 1/coarsest^2 from a radius on, s as it widens from there.
double more_around(double radius, const Widening& widening, double coarsest) {
  constexpr int pieces = 1000;
  double particles = 0;
  for (int k = 0; k < pieces; ++k) {
    const double d = (k + 0.5) / pieces * widening.end(), s = widening.at(d);
    particles += 2 * std::numbers::pi * (radius + d) * widening.end() / pieces *
                 (1 / (s * s) - 1 / (coarsest * coarsest));
  }
  return particles;
}

double more_by_regions(const SphSettings& own) {
  const double coarsest = coarsest_of(own);
  double particles = 0;
  for (const RegionSettings& region : own.regions) {
    const double area = std::numbers::pi * region.half_axes[0] * region.half_axes[1];
    particles += area * (1 / (region.spacing * region.spacing) - 1 / (coarsest * coarsest)) +
                 more_around(std::sqrt(area / std::numbers::pi),
                             {region.spacing, coarsest, 0, own.growth}, coarsest);
  }
  return particles;
}

}  // namespace

double expected_particles(const SphCase& scene) {
  const SphSettings& own = scene.sph;
  const double more = more_by_regions(own), coarsest = coarsest_of(own);
  if (!scene.body) {
    const double side = (*own.box)[2] - (*own.box)[0];
    return side * side / (coarsest * coarsest) + more;
  }
  const double radius = radius_of(*scene.body);
  const WantedSpacing wanted = beside_body(scene);
  const auto [x0, y0, x1, y1] = *own.box;
  const double outermost = std::sqrt((x1 - x0) * (y1 - y0) / std::numbers::pi);
  constexpr int pieces = 1000;
  double particles = more;
  for (int k = 0; k < pieces; ++k) {
    const double r = radius * std::pow(outermost / radius, (k + 0.5) / pieces);
    const double s = wanted.at({r, 0});
    particles += 2 * std::numbers::pi * r * r * std::log(outermost / radius) / pieces / (s * s);
  }
  return particles;
}

}  // namespace vortree::sph
