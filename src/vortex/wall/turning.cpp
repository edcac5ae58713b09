#include "vortex/wall/turning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vortex/wall/linear_system.hpp"
#include "vortex/wall/panel_kernel.hpp"

namespace vortree::vortex {
namespace {

using std::numbers::pi;

/// Weights of int_0^2pi ln(4 sin^2((s - s')/2)) f(s') ds' for values of f at n even places, by how
/// many of them f's place is from s.
std::vector<double> weights_of_logarithm(std::size_t n) {
  std::vector<double> weights(n);
  for (std::size_t k = 0; k < n; ++k) {
    double sum = 0;
    for (std::size_t m = 1; 2 * m < n; ++m) sum += std::cos(2 * pi * ((m * k) % n) / n) / m;
    if (n % 2 == 0) sum += (k % 2 ? -1.0 : 1.0) / n;
    weights[k] = -4 * pi / n * sum;
  }
  return weights;
}

/// ln|x_i - x_j| less its singular part; beside itself |dx/ds'|, s' going from 0 to 2 pi as t does
/// around.
double smooth_logarithm(const Wall& wall, std::size_t i, std::size_t j) {
  const double n = static_cast<double>(wall.panels());
  if (i == j) return std::log(wall.panel_length(i) * n / (2 * pi));
  const Vec2 d = wall.middle(i) - wall.middle(j);
  const double sine = 2 * std::sin(pi * (static_cast<double>(i) - static_cast<double>(j)) / n);
  return 0.5 * std::log(dot(d, d) / (sine * sine));
}

/// Tangential velocity of the patch at the middles of panels.
std::vector<double> along_wall(const Wall& wall) {
  const std::size_t n = wall.panels();
  const std::vector<double> weights = weights_of_logarithm(n);
  std::vector<double> w(n);
  for (std::size_t i = 0; i < n; ++i) {
    Vec2 sum;
    for (std::size_t j = 0; j < n; ++j) {
      const double b = wall.panel_length(j), per_parameter = b * static_cast<double>(n) / (2 * pi);
      const double logarithm =
          0.5 * per_parameter * weights[(i + n - j) % n] + b * smooth_logarithm(wall, i, j);
      sum += logarithm * wall.tangent(j);
    }
    w[i] = -dot(sum, wall.tangent(i)) / pi;
  }
  return w;
}

/// The sheet with that tangential velocity outside.
std::vector<double> sheet_outside(const Wall& wall, std::span<const double> w) {
  const std::size_t n = wall.panels();
  std::vector<double> a(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::vector<double> k = wall.kernel(i);
    for (std::size_t j = 0; j < n; ++j)
      a[i * n + j] = (i == j ? 0.5 : 0.0) + panel::inverse_two_pi * wall.panel_length(j) * k[j];
  }
  return LinearSystem(a, n).solve(w);
}

/// Averages over panels of what is smooth and known at their middles, to O(b^4).
std::vector<double> averaged(std::span<const double> at_middles, const Wall& wall) {
  const std::size_t n = at_middles.size();
  std::vector<double> mean(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto by_own = [&](std::size_t k) {
      return wall.panel_length(k) / wall.panel_length(i) * at_middles[k];
    };
    mean[i] =
        at_middles[i] + (by_own((i + 1) % n) - 2 * at_middles[i] + by_own((i + n - 1) % n)) / 24;
  }
  return mean;
}

}  // namespace

Turning::Turning(const Wall& wall) {
  const std::vector<double> w = along_wall(wall);
  sheet = sheet_outside(wall, w);
  std::vector<double> beyond = w;
  for (std::size_t i = 0; i < w.size(); ++i)
    beyond[i] -= dot(left_of(wall.middle(i)), wall.tangent(i));
  slip = averaged(beyond, wall);
  circulation = 2 * wall.area();
  moment = 2 * wall.area_moment();
  of_centroid = 0.5 * moment;
}

Turning Turning::among(const Wall& all, std::size_t k, double angle) const {
  if (all.rings().size() == 1 && angle == 0) return *this;
  const Ring& ring = all.rings()[k];
  Turning there = *this;
  there.of_centroid = Turn(angle)(of_centroid);
  there.moment = 2.0 * there.of_centroid + circulation * ring.centre;
  there.sheet.assign(all.panels(), 0);
  std::ranges::copy(sheet, ring.of(there.sheet).begin());
  Velocities u(all.samples().size());
  all.add_velocity(there.sheet, {.method = fmm::SumMethod::direct}, all.samples(), u);
  there.slip.clear();
  for (std::size_t i = 0; i < all.panels(); ++i)
    there.slip.push_back(dot(all.mean_of_samples(u, i), all.tangent(i)));
  std::ranges::copy(slip, ring.of(there.slip).begin());
  return there;
}

std::vector<double> gained_along_wall(const Wall& wall, const Ring& ring, const Gain& gain) {
  std::vector<double> gained(wall.panels());
  for (std::size_t i = ring.first; i < ring.end(); ++i) {
    const Vec2 x = wall.middle(i) - ring.centre;
    gained[i] =
        dot(gain.velocity + gain.faster * left_of(x) - (gain.rate * gain.rate * gain.dt) * x,
            wall.tangent(i));
  }
  return gained;
}

}  // namespace vortree::vortex
