#include "sph/adapt/wishes.hpp"

#include <algorithm>
#include <cmath>

#include "sph/adapt/tuning.hpp"

namespace vortree::sph {
namespace {

/// Root mean square of the vorticity of a particle and its neighbors, by volumes.
double strength(const Population& population, std::size_t i) {
  const Cloud& cloud = population.cloud();
  double volume = cloud.volume(i), sum = volume * std::pow(population.vorticity(i), 2);
  population.for_each_neighbor(i, [&](std::size_t j, Vec2) {
    if (!cloud.inside(j)) return;
    volume += cloud.volume(j);
    sum += cloud.volume(j) * std::pow(population.vorticity(j), 2);
  });
  return std::sqrt(sum / volume);
}

/// No wider than from neighbor to neighbor spacing may widen; true if something has changed.
bool level_out(const Population& population, std::vector<double>& wish) {
  const std::vector<double> before = wish;
  bool changed = false;
#pragma omp parallel for schedule(static) reduction(|| : changed)
  for (std::size_t i = 0; i < wish.size(); ++i) {
    population.for_each_neighbor(i, [&](std::size_t j, Vec2 d) {
      wish[i] = std::min(wish[i], before[j] + steepest * std::sqrt(dot(d, d)));
    });
    changed = changed || wish[i] < before[i];
  }
  return changed;
}

std::vector<double> by_strength(const Population& population, const VorticityWish& of,
                                double coarsest) {
  std::vector<double> wish(population.old(), coarsest);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < wish.size(); ++i) {
    if (!population.cloud().inside(i)) continue;
    const double omega = strength(population, i);
    const double least =
        std::max(of.finest, coarsest - steepest * of.box.depth(population.cloud().at(i)));
    if (omega * coarsest > of.change)
      wish[i] = std::min(coarsest, std::max(of.change / omega, least));
  }
  while (level_out(population, wish)) {
  }
  return wish;
}

}  // namespace

std::vector<double> wishes(const Population& population, const WantedSpacing& wanted,
                           const std::optional<VorticityWish>& by_vorticity) {
  const Cloud& cloud = population.cloud();
  std::vector<double> wish(population.old(), 0);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < wish.size(); ++i)
    if (cloud.free(i)) wish[i] = wanted.at(cloud.at(i));
  if (!by_vorticity) return wish;
  const std::vector<double> other = by_strength(population, *by_vorticity, wanted.coarsest());
  for (std::size_t i = 0; i < wish.size(); ++i) wish[i] = std::min(wish[i], other[i]);
  return wish;
}

}  // namespace vortree::sph
