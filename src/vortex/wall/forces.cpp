#include "vortex/wall/forces.hpp"

#include <cmath>

#include "base/ordered_sum.hpp"
#include "vortex/cores/folded_centroid.hpp"
#include "vortex/cores/folded_core.hpp"
#include "vortex/wall/along_wall.hpp"

namespace vortree::vortex {

namespace {

/// zeta(1/2, a), the sum over k >= 0 of (k + a)^(-1/2) less its divergent part 2 sqrt(k + a).
/// error  1e-8 for a >= 1: Euler's and Maclaurin's formula from the eighth term on
double hurwitz_zeta_of_half(double a) {
  double sum = 0;
  for (int k = 0; k < 8; ++k) sum += 1 / std::sqrt(k + a);
  const double z = 8 + a, root = std::sqrt(z);
  return sum - 2 * root + 0.5 / root + 1 / (24 * z * root) - 1 / (384 * z * z * z * root);
}

/// What the last sheet adds to the wall vorticity for each unit of it.
double of_fresh_sheet(double nu, double dt, double sigma_0) {
  if (nu <= 0) return 0;
  const double age = sigma_0 * sigma_0 / (4 * nu * dt);  // of a released core [dt]
  return -hurwitz_zeta_of_half(1 + age) * folded::inverse_sqrt_pi / std::sqrt(nu * dt);
}

/// Calls use(core) for those blobs of first .. last whose cores reach the wall.
void for_each_at_wall(const Blobs& blobs, const Wall& wall, std::size_t first, std::size_t last,
                      auto use) {
  for (std::size_t j = first; j < last; ++j) {
    const Core core = blobs.core(j);
    if (wall.shape().beyond(blobs.centre(j), folded::support * widest(core))) continue;
    body::WallPoint w = wall.shape().nearest(blobs.centre(j));
    const Covariance v = core.covariance(w.normal);
    w.distance = height(w, v);
    const double across = std::sqrt(2 * v.nn), along = std::sqrt(2 * v.tt);
    if (folded::applies(w.distance, across)) use(CoreAtWall{blobs.gamma[j], w, across, along});
  }
}

}  // namespace

std::vector<double> wall_vorticity(const Blobs& blobs, std::span<const double> sheet,
                                   const Wall& wall, double nu, double dt, double sigma_0) {
  const AlongWall along(wall);
  const double b = wall.panel_length(), fresh = of_fresh_sheet(nu, dt, sigma_0);
  std::vector<double> omega = ordered_sum(blobs.size(), [&](std::size_t first, std::size_t last) {
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
                    double dt, double sigma_0) {
  Vec2 force;
  const double fresh = of_fresh_sheet(nu, dt, sigma_0);
  for (std::size_t i = 0; i < sheet.size(); ++i)
    force += (nu * fresh * sheet[i] * wall.panel_length()) * wall.tangent(i);
  force += ordered_sum(blobs.size(), [&](std::size_t first, std::size_t last) {
    Vec2 some;
    for_each_at_wall(blobs, wall, first, last, [&](const CoreAtWall& core) {
      some += (nu * trace(core).amount) * core.at.tangent();
    });
    return some;
  });
  return force;
}

}  // namespace vortree::vortex
