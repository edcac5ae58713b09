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
              const Wall& wall, const AlongWall& along, WallShear& shear) {
  if (nearest.distance == INFINITY) return;
  const Covariance v = blobs.core(j).covariance(nearest.normal);
  const Vec2 at_wall = blobs.centre(j) - nearest.distance * nearest.normal;
  nearest.distance = height(nearest, v);
  const double across = std::sqrt(2 * v.nn);
  if (!folded::applies(nearest.distance, across)) return;
  const Trace trace =
      vortex::trace(CoreAtWall{blobs.gamma[j], nearest, across, std::sqrt(2 * v.tt)});
  along.add(trace, shear.vorticity);
  const std::size_t body = wall.ring_at(nearest.arc);
  const Vec2 arm = at_wall - wall.rings()[body].centre;
  shear.friction[body] +=
      {(nu * trace.amount) * nearest.tangent(), nu * trace.amount * dot(arm, nearest.normal)};
}

/// What the last sheet does to a body.
void add_sheet(std::span<const double> sheet, const Wall& wall, std::size_t body, double nu,
               double fresh, const AlongWall& along, WallShear& shear) {
  const Ring& ring = wall.rings()[body];
  for (std::size_t i = ring.first; i < ring.end(); ++i) {
    const double b = wall.panel_length(i);
    along.add({fresh * sheet[i] * b, wall.arc(i), 0}, shear.vorticity);
    const Vec2 arm = wall.middle(i) - ring.centre;
    shear.friction[body] += {(nu * fresh * sheet[i] * b) * wall.tangent(i),
                             nu * fresh * sheet[i] * b * dot(left_of(arm), wall.tangent(i))};
  }
}

}  // namespace

Load& Load::operator+=(const Load& other) {
  force += other.force;
  moment += other.moment;
  return *this;
}

Load operator*(double factor, const Load& load) {
  return {factor * load.force, factor * load.moment};
}

Load total(std::span<const Load> loads, const Wall& wall) {
  Load sum;
  for (std::size_t k = 0; k < loads.size(); ++k)
    sum += {loads[k].force, loads[k].moment + dot(left_of(wall.rings()[k].centre), loads[k].force)};
  return sum;
}

WallShear& WallShear::operator+=(const WallShear& other) {
  for (std::size_t i = 0; i < vorticity.size(); ++i) vorticity[i] += other.vorticity[i];
  for (std::size_t k = 0; k < friction.size(); ++k) friction[k] += other.friction[k];
  return *this;
}

WallShear wall_shear(const Blobs& blobs, std::span<const double> sheet, const Wall& wall, double nu,
                     double dt, double sigma_0, const WallPoints& found) {
  const AlongWall along(wall);
  const body::Shape* shape = &wall.shape();
  WallShear shear = ordered_sum(blobs.size(), [&](std::size_t first, std::size_t last) {
    WallShear some(wall);
    for (std::size_t j = first; j < last; ++j)
      add_blob(blobs, j, found.nearest(j, blobs.centre(j), reach_of(blobs.core(j)), shape), nu,
               wall, along, some);
    return some;
  });
  for (std::size_t body = 0; body < wall.rings().size(); ++body)
    add_sheet(sheet, wall, body, nu, of_fresh_sheet(nu, dt, sigma_0), along, shear);
  return shear;
}

std::vector<Load> pressure_loads(std::span<const double> sheet, const Wall& wall, double dt) {
  std::vector<Load> loads;
  for (const Ring& ring : wall.rings()) {
    Vec2 first;
    double second = 0;
    for (std::size_t i = ring.first; i < ring.end(); ++i) {
      const Vec2 arm = wall.middle(i) - ring.centre;
      first = first + (sheet[i] * wall.panel_length(i)) * arm;
      second += wall.panel_length(i) / ring.length * sheet[i] * dot(arm, arm);
    }
    loads.push_back({{-first.y / dt, first.x / dt}, ring.length / (2 * dt) * second});
  }
  return loads;
}

}  // namespace vortree::vortex
