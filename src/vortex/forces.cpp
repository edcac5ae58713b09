#include "vortex/forces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vortex/folded_core.hpp"

namespace vortree::vortex {

namespace {

/// Wall vorticity for each unit of a sheet let in evenly during dt: (1/dt) int_0^dt (pi nu
/// tau)^(-1/2) dtau.
double of_fresh_sheet(double nu, double dt) {
  return nu > 0 ? 2 * folded::inverse_sqrt_pi / std::sqrt(nu * dt) : 0;
}

}  // namespace

std::vector<double> wall_vorticity(const Blobs& blobs, std::span<const double> sheet,
                                   const Wall& wall, double nu, double dt) {
  const auto panels = static_cast<std::ptrdiff_t>(wall.panels());
  std::vector<double> omega(sheet.begin(), sheet.end());
  for (double& w : omega) w *= of_fresh_sheet(nu, dt);
  for (std::size_t j = 0; j < blobs.size(); ++j) {
    const double s = blobs.sigma[j];
    if (wall.shape().beyond(blobs.centre(j), folded::reach * s)) continue;
    const WallPoint w = wall.shape().nearest(blobs.centre(j));
    if (!folded::applies(w.distance, s)) continue;
    const auto here = static_cast<std::ptrdiff_t>(w.arc / wall.panel_length());
    const auto reach = std::min(
        static_cast<std::ptrdiff_t>(folded::reach * s / wall.panel_length()) + 2, (panels - 1) / 2);
    for (std::ptrdiff_t k = here - reach; k <= here + reach; ++k) {
      const std::ptrdiff_t i = (k + panels) % panels;
      const Vec2 d = wall.middle(i) - blobs.centre(j);
      omega[i] +=
          2 * std::numbers::inv_pi * blobs.gamma[j] / (s * s) * std::exp(-dot(d, d) / (s * s));
    }
  }
  return omega;
}

Vec2 pressure_force(std::span<const double> sheet, const Wall& wall, double dt) {
  const Vec2 moment = wall.first_moment(sheet);
  return {-moment.y / dt, moment.x / dt};
}

Vec2 friction_force(const Blobs& blobs, std::span<const double> sheet, const Wall& wall, double nu,
                    double dt) {
  Vec2 force;
  for (std::size_t i = 0; i < sheet.size(); ++i)
    force =
        force + (nu * of_fresh_sheet(nu, dt) * sheet[i] * wall.panel_length()) * wall.tangent(i);
  for (std::size_t j = 0; j < blobs.size(); ++j) {
    const double s = blobs.sigma[j];
    if (wall.shape().beyond(blobs.centre(j), folded::reach * s)) continue;
    const WallPoint w = wall.shape().nearest(blobs.centre(j));
    if (!folded::applies(w.distance, s)) continue;
    const double along = 2 * folded::inverse_sqrt_pi * blobs.gamma[j] / s *
                         std::exp(-w.distance * w.distance / (s * s)) /
                         std::sqrt(1 + w.curvature * w.distance);
    force = force + (nu * along) * w.tangent();
  }
  return force;
}

}  // namespace vortree::vortex
