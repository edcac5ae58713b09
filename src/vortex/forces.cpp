#include "vortex/forces.hpp"

#include <cmath>

#include "vortex/along_wall.hpp"
#include "vortex/folded_core.hpp"
#include "vortex/in_parts.hpp"

namespace vortree::vortex {

namespace {

/// Wall vorticity for each unit of a sheet let in evenly during dt: (1/dt) int_0^dt (pi nu
/// tau)^(-1/2) dtau.
double of_fresh_sheet(double nu, double dt) {
  return nu > 0 ? 2 * folded::inverse_sqrt_pi / std::sqrt(nu * dt) : 0;
}

/// Calls use(core) for those blobs of first .. last whose cores reach the wall.
void for_each_at_wall(const Blobs& blobs, const Wall& wall, std::size_t first, std::size_t last,
                      auto use) {
  for (std::size_t j = first; j < last; ++j) {
    const Core core = blobs.core(j);
    if (wall.shape().beyond(blobs.centre(j), folded::reach * widest(core))) continue;
    const WallPoint w = wall.shape().nearest(blobs.centre(j));
    const Covariance v = core.covariance(w.normal);
    const double across = std::sqrt(2 * v.nn), along = std::sqrt(2 * v.tt);
    if (folded::applies(w.distance, across)) use(CoreAtWall{blobs.gamma[j], w, across, along});
  }
}

}  // namespace

std::vector<double> wall_vorticity(const Blobs& blobs, std::span<const double> sheet,
                                   const Wall& wall, double nu, double dt) {
  const AlongWall along(wall);
  const double b = wall.panel_length(), fresh = of_fresh_sheet(nu, dt);
  std::vector<double> omega = sum_in_parts(blobs.size(), [&](std::size_t first, std::size_t last) {
    std::vector<double> some(wall.panels());
    for_each_at_wall(blobs, wall, first, last,
                     [&](const CoreAtWall& core) { along.add(trace(core), some); });
    return some;
  });
  for (std::size_t i = 0; i < sheet.size(); ++i)
    along.add({fresh * sheet[i] * b, (static_cast<double>(i) + 0.5) * b, 0}, omega);
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
    for_each_at_wall(blobs, wall, first, last, [&](const CoreAtWall& core) {
      some += (nu * trace(core).amount) * core.at.tangent();
    });
    return some;
  });
  return force;
}

}  // namespace vortree::vortex
