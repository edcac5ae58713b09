#include "sph/adapt/refine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "sph/adapt/tuning.hpp"

namespace vortree::sph {
namespace {

double magnitude(Vec2 a) {
  return std::sqrt(dot(a, a));
}

void split_in_four(Population& population, std::size_t i) {
  const double s = population.cloud().spacing[i];
  for (const Vec2 corner : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{1, 1}})
    population.add(i, s / 4 * corner, s / 2);
  population.remove(i);
}

/// Of eight directions, the one with most room for two at +- 0.35 s.
Vec2 widest_gap(const Population& population, std::size_t i) {
  const double s = population.cloud().spacing[i];
  Vec2 best{1, 0};
  double room = -1;
  for (int k = 0; k < 8; ++k) {
    const Vec2 e{std::cos(k * std::numbers::pi / 8), std::sin(k * std::numbers::pi / 8)};
    double nearest = std::numeric_limits<double>::max();
    population.for_each_neighbor(i, [&](std::size_t, Vec2 d) {
      for (const double side : {-0.35, 0.35})
        nearest = std::min(nearest, magnitude(d - side * s * e));
    });
    if (nearest > room) room = nearest, best = e;
  }
  return best;
}

void split_in_two(Population& population, std::size_t i) {
  const double s = population.cloud().spacing[i];
  const Vec2 e = widest_gap(population, i);
  for (const double side : {-0.3, 0.3}) population.add(i, side * s * e, s / std::numbers::sqrt2);
  population.remove(i);
}

/// The nearest with which a particle makes no more than is wanted, or itself.
std::size_t partner(const Population& population, std::size_t i, double wanted,
                    const std::vector<char>& taken) {
  const Cloud& cloud = population.cloud();
  const double own = cloud.volume(i);
  std::size_t best = i;
  double least = std::numeric_limits<double>::max();
  population.for_each_neighbor(i, [&](std::size_t j, Vec2 d) {
    const double r = magnitude(d);
    if (!cloud.free(j) || taken[j] || own + cloud.volume(j) > most_merged * wanted) return;
    if (r < least && r < 1.3 * std::max(cloud.spacing[i], cloud.spacing[j])) least = r, best = j;
  });
  return best;
}

}  // namespace

void refine(Population& population, const std::vector<double>& wanted) {
  const Cloud& cloud = population.cloud();
  std::vector<char> taken(population.old(), 0);
  for (std::size_t i = 0; i < population.old(); ++i) {
    if (!cloud.free(i) || population.gone(i) || taken[i]) continue;
    const double volume = wanted[i] * wanted[i], own = cloud.volume(i);
    if (own > split_above * volume) {
      taken[i] = 1;
      if (own > split_in_four_above * volume)
        split_in_four(population, i);
      else
        split_in_two(population, i);
    } else if (own < merge_below * volume) {
      const std::size_t j = partner(population, i, volume, taken);
      if (j == i) continue;
      taken[i] = taken[j] = 1;
      population.merge(i, j);
    }
  }
}

void correct_volumes(Population& population, const std::vector<double>& wanted) {
  const Cloud& cloud = population.cloud();
  const std::size_t n = population.old();
  const std::vector<char> beside = population.beside_edge();
  std::vector<double> share(n, 1), spacing(cloud.spacing.begin(), cloud.spacing.begin() + n);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i)
    if (cloud.free(i)) share[i] = std::pow(cloud.spacing[i] / wanted[i], 2);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    if (!cloud.free(i)) continue;
    double sum = 0;
    int count = 0;
    population.for_each_neighbor(i, [&](std::size_t j, Vec2) { sum += share[j], ++count; });
    double change = count ? evening_rate * (sum / count / share[i] - 1) : 0;
    if (!beside[i]) change += volume_rate * std::clamp(1 - population.filling(i), -0.5, 0.5);
    spacing[i] *= std::sqrt(1 + std::clamp(change, -0.1, 0.1));
  }
  for (std::size_t i = 0; i < n; ++i) population.resize(i, spacing[i]);
}

}  // namespace vortree::sph
