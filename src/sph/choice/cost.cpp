#include "sph/choice/cost.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "body/extent.hpp"
#include "body/shapes/circle.hpp"
#include "body/shapes/shapes.hpp"
#include "sph/adapt/wanted_spacing.hpp"
#include "sph/boundary/outer_box.hpp"
#include "sph/boundary/standing_bodies.hpp"
#include "sph/boundary/wall_nodes.hpp"
#include "sph/setup.hpp"

namespace vortree::sph {
namespace {

double radius_of(const body::BodySettings& body) {
  return body::perimeter_of(body) / (2 * std::numbers::pi);
}

WantedSpacing beside(const body::BodySettings& body, const SphSettings& own) {
  return {body::circle({}, radius_of(body)), own.spacing, own.levels, own.zone, own.growth};
}

}  // namespace

double spacing_at_box(const SphCase& scene) {
  const auto [x0, y0, x1, y1] = *scene.sph.box;
  double least = INFINITY;
  for (const body::BodySettings& one : flow::every_body(scene)) {
    const auto [x, y] = one.centre;
    const double nearest = std::min({x - x0, x1 - x, y - y0, y1 - y});
    least = std::min(least, beside(one, scene.sph).at({nearest, 0}));
  }
  return least;
}

double extent_of(const body::BodySettings& body) {
  const auto [half_x, half_y] = body::half_extent(body);
  return std::max({body::length_of(body), 2 * half_x, 2 * half_y});
}

double thickness_of(const body::BodySettings& body) {
  return area_of(*body::outline_of(body)) / body::length_of(body);
}

BodyLengths lengths_of(const flow::Case& of) {
  BodyLengths all{INFINITY, 0};
  for (const body::BodySettings& one : flow::every_body(of)) {
    const double length = body::length_of(one);
    all = {std::min(all.shortest, length), std::max(all.longest, length)};
  }
  return all;
}

double gap_of(const flow::Case& of) {
  double least = INFINITY;
  for (const body::NearestApproach& one : of.meetings) least = std::min(least, one.gap);
  return least;
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

/// Bodies taken for circles.
StandingBodies as_circles(const SphCase& scene) {
  std::vector<StandingBody> all;
  for (const body::BodySettings& one : flow::every_body(scene))
    all.push_back(
        stand(body::circle({}, radius_of(one)), scene.sph.spacing, {one.centre[0], one.centre[1]}));
  return StandingBodies(std::move(all));
}

/// The integral of 1/s^2 - 1/coarsest^2 around one of several circles, where it is the nearest.
double more_around(const StandingBodies& all, const StandingBody& one, const Widening& widening,
                   double coarsest) {
  constexpr int pieces = 200, directions = 64;
  const double radius = one.shape->perimeter() / (2 * std::numbers::pi);
  const double dr = widening.end() / pieces, turn = 2 * std::numbers::pi / directions;
  double particles = 0;
  for (int k = 0; k < pieces; ++k) {
    const double r = radius + (k + 0.5) * dr, s = widening.at(r - radius);
    for (int j = 0; j < directions; ++j) {
      const Vec2 at = one.centre + r * Vec2{std::cos(j * turn), std::sin(j * turn)};
      if (&all.nearest(at) == &one)
        particles += r * turn * dr * (1 / (s * s) - 1 / (coarsest * coarsest));
    }
  }
  return particles;
}

double among_several(const SphCase& scene) {
  const SphSettings& own = scene.sph;
  const double coarsest = coarsest_of(own);
  const Widening widening(own.spacing, coarsest, own.zone, own.growth);
  const StandingBodies all = as_circles(scene);
  const auto [x0, y0, x1, y1] = *own.box;
  double particles = ((x1 - x0) * (y1 - y0) - all.area()) / (coarsest * coarsest);
  for (const StandingBody& one : all) particles += more_around(all, one, widening, coarsest);
  return particles;
}

}  // namespace

double expected_particles(const SphCase& scene) {
  const SphSettings& own = scene.sph;
  if (!scene.others.empty()) return among_several(scene) + more_by_regions(own);
  const double more = more_by_regions(own), coarsest = coarsest_of(own);
  if (!scene.body) {
    const double side = (*own.box)[2] - (*own.box)[0];
    return side * side / (coarsest * coarsest) + more;
  }
  const double radius = radius_of(*scene.body);
  const WantedSpacing wanted = beside(*scene.body, own);
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
