#include "vortex/forces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vortex/folded_core.hpp"
#include "vortex/in_parts.hpp"

namespace vortree::vortex {

namespace {

/// Wall vorticity for each unit of a sheet let in evenly during dt: (1/dt) int_0^dt (pi nu
/// tau)^(-1/2) dtau.
double of_fresh_sheet(double nu, double dt) {
  return nu > 0 ? 2 * folded::inverse_sqrt_pi / std::sqrt(nu * dt) : 0;
}

}  // namespace

namespace {

/// Calls use(j, nearest wall point, widths across and along the wall) for those blobs of first ..
/// last whose cores reach the wall.
void for_each_at_wall(const Blobs& blobs, const Wall& wall, std::size_t first, std::size_t last,
                      auto use) {
  for (std::size_t j = first; j < last; ++j) {
    const Core core = blobs.core(j);
    if (wall.shape().beyond(blobs.centre(j), folded::reach * widest(core))) continue;
    const WallPoint w = wall.shape().nearest(blobs.centre(j));
    const Covariance v = core.covariance(w.normal);
    const double across = std::sqrt(2 * v.nn), along = std::sqrt(2 * v.tt);
    if (folded::applies(w.distance, across)) use(j, w, across, along);
  }
}

}  // namespace

std::vector<double> wall_vorticity(const Blobs& blobs, std::span<const double> sheet,
                                   const Wall& wall, double nu, double dt) {
  const auto panels = static_cast<std::ptrdiff_t>(wall.panels());
  std::vector<double> omega = sum_in_parts(blobs.size(), [&](std::size_t first, std::size_t last) {
    std::vector<double> some(panels);
    for_each_at_wall(blobs, wall, first, last,
                     [&](std::size_t j, const WallPoint& w, double across, double along) {
                       const double s = along;
                       const auto here = static_cast<std::ptrdiff_t>(w.arc / wall.panel_length());
                       const auto within =
                           static_cast<std::ptrdiff_t>(folded::reach * s / wall.panel_length()) + 2;
                       const auto reach = std::min(within, (panels - 1) / 2);
                       for (std::ptrdiff_t k = here - reach; k <= here + reach; ++k) {
                         const std::ptrdiff_t i = (k + panels) % panels;
                         const Vec2 d = wall.middle(i) - blobs.centre(j);
                         const double n = dot(d, w.normal) / across,
                                      t = dot(d, w.tangent()) / along;
                         some[i] += 2 * std::numbers::inv_pi * blobs.gamma[j] / (across * along) *
                                    std::exp(-n * n - t * t);
                       }
                     });
    return some;
  });
  for (std::size_t i = 0; i < omega.size(); ++i) omega[i] += of_fresh_sheet(nu, dt) * sheet[i];
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
    force += (nu * of_fresh_sheet(nu, dt) * sheet[i] * wall.panel_length()) * wall.tangent(i);
  force += sum_in_parts(blobs.size(), [&](std::size_t first, std::size_t last) {
    Vec2 some;
    for_each_at_wall(blobs, wall, first, last,
                     [&](std::size_t j, const WallPoint& w, double s, double) {
                       const double along = 2 * folded::inverse_sqrt_pi * blobs.gamma[j] / s *
                                            std::exp(-w.distance * w.distance / (s * s)) /
                                            std::sqrt(1 + w.curvature * w.distance);
                       some += (nu * along) * w.tangent();
                     });
    return some;
  });
  return force;
}

}  // namespace vortree::vortex
