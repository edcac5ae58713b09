#include "sph/boundary/open_boundary.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "sph/boundary/tuning.hpp"

namespace vortree::sph {
namespace {

double magnitude(Vec2 a) {
  return std::sqrt(dot(a, a));
}

bool beyond_box(const Cloud& cloud, std::size_t i, const Confines& confines) {
  return confines.box.depth(cloud.at(i)) < least_depth * cloud.spacing[i];
}

bool among_rings(const Cloud& cloud, std::size_t i, const Confines& confines) {
  return confines.bodies.within(cloud.at(i), confines.rings + least_beyond_rings);
}

bool crowded(const Population& population, std::size_t i) {
  // In a step particles come nearer to each other by less than half a spacing.
  if (population.nearest(i) > too_close + 0.5) return false;
  const Cloud& cloud = population.cloud();
  bool found = false;
  population.for_each_neighbor(i, [&](std::size_t j, Vec2 d) {
    const double s = 0.5 * (cloud.spacing[i] + cloud.spacing[j]);
    const bool smaller =
        cloud.spacing[i] < cloud.spacing[j] || (cloud.spacing[i] == cloud.spacing[j] && i > j);
    found = found || (cloud.free(j) && smaller && magnitude(d) < too_close * s);
  });
  return found;
}

/// A node beside which a gap may open, and where its particle would be, as seen from it.
struct BirthPlace {
  std::size_t node;
  Vec2 by;
};

std::vector<BirthPlace> places(const Cloud& cloud, std::size_t old, const Confines& confines) {
  std::vector<BirthPlace> found;
  for (std::size_t i = 0; i < old; ++i) {
    const bool edge = cloud.kind[i] >= ParticleKind::outer && !corner(confines.box, cloud.at(i));
    const bool ring = cloud.kind[i] == ParticleKind::ring && cloud.place[i] == confines.rings;
    if (edge) found.push_back({i, birth_depth * cloud.spacing[i] * cloud.normal(i)});
    if (ring) found.push_back({i, confines.bodies.nearest(cloud.at(i)).spacing * cloud.normal(i)});
  }
  return found;
}

}  // namespace

void take_away(Population& population, const Confines& confines) {
  const Cloud& cloud = population.cloud();
  enum Fate : char { stays, leaves, crowds };
  std::vector<Fate> fate(population.old(), stays);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < fate.size(); ++i) {
    if (!cloud.free(i)) continue;
    if (beyond_box(cloud, i, confines) || among_rings(cloud, i, confines))
      fate[i] = leaves;
    else if (crowded(population, i))
      fate[i] = crowds;
  }
  // Of two that crowd each other one may stay.
  for (std::size_t i = 0; i < fate.size(); ++i)
    if (fate[i] == leaves || (fate[i] == crowds && crowded(population, i))) population.remove(i);
}

void fill_gaps(Population& population, const Confines& confines) {
  const Cloud& cloud = population.cloud();
  std::vector<Vec2> born;
  for (const auto& [node, by] : places(cloud, population.old(), confines)) {
    const double s = cloud.spacing[node];
    double nearest = std::numeric_limits<double>::max();
    population.for_each_neighbor(node, [&](std::size_t j, Vec2 d) {
      if (cloud.free(j)) nearest = std::min(nearest, magnitude(d - by));
    });
    const Vec2 at = cloud.at(node) + by;
    for (const Vec2 other : born) nearest = std::min(nearest, magnitude(other - at));
    if (nearest <= gap * s) continue;
    population.add_among(node, by, s);
    born.push_back(at);
  }
}

}  // namespace vortree::sph
