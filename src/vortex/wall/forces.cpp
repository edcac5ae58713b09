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

/// What a blob shears the wall with whose core reaches it.
void add_blob(const Blobs& blobs, std::size_t j, body::WallPoint nearest, double nu,
              const AlongWall& along, WallShear& shear) {
  if (nearest.distance == INFINITY) return;
  const Covariance v = blobs.core(j).covariance(nearest.normal);
  const Vec2 at_wall = blobs.centre(j) - nearest.distance * nearest.normal;
  nearest.distance = height(nearest, v);
  const double across = std::sqrt(2 * v.nn);
  if (!folded::applies(nearest.distance, across)) return;
  const Trace trace =
      vortex::trace(CoreAtWall{blobs.gamma[j], nearest, across, std::sqrt(2 * v.tt)});
  along.add(trace, shear.vorticity);
  shear.friction += (nu * trace.amount) * nearest.tangent();
  shear.moment += nu * trace.amount * dot(at_wall, nearest.normal);
}

/// What the last sheet does.
void add_sheet(std::span<const double> sheet, const Wall& wall, double nu, double fresh,
               const AlongWall& along, WallShear& shear) {
  const double b = wall.panel_length();
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    along.add({fresh * sheet[i] * b, (static_cast<double>(i) + 0.5) * b, 0}, shear.vorticity);
    shear.friction += (nu * fresh * sheet[i] * b) * wall.tangent(i);
    shear.moment += nu * fresh * sheet[i] * b * dot(left_of(wall.middle(i)), wall.tangent(i));
  }
}

}  // namespace

WallShear& WallShear::operator+=(const WallShear& other) {
  for (std::size_t i = 0; i < vorticity.size(); ++i) vorticity[i] += other.vorticity[i];
  friction += other.friction;
  moment += other.moment;
  return *this;
}

WallShear wall_shear(const Blobs& blobs, std::span<const double> sheet, const Wall& wall, double nu,
                     double dt, double sigma_0, const WallPoints& found) {
  const AlongWall along(wall);
  const body::Shape* shape = &wall.shape();
  WallShear shear = ordered_sum(blobs.size(), [&](std::size_t first, std::size_t last) {
    WallShear some{std::vector<double>(wall.panels()), {}};
    for (std::size_t j = first; j < last; ++j)
      add_blob(blobs, j, found.nearest(j, blobs.centre(j), reach_of(blobs.core(j)), shape), nu,
               along, some);
    return some;
  });
  add_sheet(sheet, wall, nu, of_fresh_sheet(nu, dt, sigma_0), along, shear);
  return shear;
}

Vec2 pressure_force(std::span<const double> sheet, const Wall& wall, double dt) {
  const Vec2 moment = wall.first_moment(sheet);
  return {-moment.y / dt, moment.x / dt};
}

double pressure_moment(std::span<const double> sheet, const Wall& wall, double dt) {
  double sum = 0;
  for (std::size_t i = 0; i < sheet.size(); ++i)
    sum += sheet[i] * dot(wall.middle(i), wall.middle(i));
  return wall.panel_length() / (2 * dt) * sum;
}

}  // namespace vortree::vortex
