#include "bench/sets/point_sets.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace vortree::bench {
namespace {

void add(PointSet& set, double x, double y) {
  set.x.push_back(x);
  set.y.push_back(y);
}

/// 0.5 <= r <= 0.55, exponentially thinner outward.
void add_layer(PointSet& set, std::size_t n, Uniform& uniform) {
  const double range = 1.0 - std::exp(-5.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double height = -0.01 * std::log(1.0 - uniform() * range);
    const double angle = 2.0 * std::numbers::pi * uniform();
    add(set, (0.5 + height) * std::cos(angle), (0.5 + height) * std::sin(angle));
  }
}

/// Gaussian clumps, what falls outside 0.5 < x < 6, |y| < 1 drawn again.
void add_wake(PointSet& set, std::size_t n, const std::array<double, 40>& centres,
              Uniform& uniform) {
  while (set.size() < n) {
    const auto clump = static_cast<std::size_t>(20 * uniform());
    const double first = uniform(), angle = 2.0 * std::numbers::pi * uniform();
    const double radius = 0.1 * std::sqrt(-2.0 * std::log(1.0 - first));
    const double x = centres[2 * clump] + radius * std::cos(angle);
    const double y = centres[2 * clump + 1] + radius * std::sin(angle);
    if (x > 0.5 && x < 6.0 && std::abs(y) < 1.0) add(set, x, y);
  }
}

void add_square(PointSet& set, std::size_t n, Uniform& uniform) {
  for (std::size_t i = 0; i < n; ++i) {
    const double x = uniform();
    add(set, x, uniform());
  }
}

/// Stratified, so that the points stay apart in double.
void add_segment(PointSet& set, std::size_t n, Uniform& uniform) {
  for (std::size_t i = 0; i < n; ++i) {
    const double t = (static_cast<double>(i) + 0.8 * uniform()) / static_cast<double>(n) * 1e-6;
    add(set, 0.3 + t * (std::numbers::sqrt3 / 2), 0.7 + t * 0.5);
  }
}

void add_spiral_of_scales(PointSet& set, std::size_t n, Uniform& uniform) {
  while (set.size() < n) {
    const double radius = std::pow(10.0, -10.0 * uniform());
    const double angle = 2.0 * std::numbers::pi * uniform();
    add(set, 0.6 + radius * std::cos(angle), 0.4 + radius * std::sin(angle));
  }
}

void shuffle(PointSet& set, Uniform& uniform) {
  for (std::size_t i = set.size(); i-- > 1;) {
    const std::size_t j = uniform.below(i + 1);
    std::swap(set.x[i], set.x[j]);
    std::swap(set.y[i], set.y[j]);
    std::swap(set.gamma[i], set.gamma[j]);
  }
}

}  // namespace

PointSet make_points(PointKind kind, std::size_t n) {
  Uniform uniform(20260101 + 1000 * static_cast<std::uint64_t>(kind));
  PointSet set;
  if (kind == PointKind::uniform) {
    add_square(set, n, uniform);
  } else if (kind == PointKind::ringwake) {
    std::array<double, 40> centres;
    for (std::size_t c = 0; c < 40; c += 2) {
      centres[c] = 0.5 + 5.5 * uniform();
      centres[c + 1] = -1.0 + 2.0 * uniform();
    }
    add_layer(set, n / 2, uniform);
    add_wake(set, n, centres, uniform);
  } else {
    add_square(set, n / 2, uniform);
    add_segment(set, n / 4, uniform);
    add_spiral_of_scales(set, n, uniform);
  }
  for (std::size_t i = 0; i < n; ++i) set.gamma.push_back(2.0 * uniform() - 1.0);
  shuffle(set, uniform);
  return set;
}

PointSet make_blobs(std::size_t n) {
  PointSet set;
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  const double spacing = 1.0 / static_cast<double>(side);
  Uniform uniform(20260101 + 1000 * 3);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = spacing * (static_cast<double>(i % side) + uniform());
    const double y = spacing * (static_cast<double>(i / side) + uniform());
    add(set, x, y);
    set.gamma.push_back(std::sin(2.0 * std::numbers::pi * x) *
                        std::sin(2.0 * std::numbers::pi * y) * spacing * spacing);
  }
  set.sigma.assign(n, 2.0 * spacing);
  shuffle(set, uniform);
  return set;
}

}  // namespace vortree::bench
