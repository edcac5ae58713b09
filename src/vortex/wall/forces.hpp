#pragma once

#include <span>
#include <vector>

#include "vortex/wall/wall.hpp"

namespace vortree::vortex {

/// vorticity  at the wall, a value a panel [1/s], smoothed along it (along_wall.hpp)
/// friction   force per unit density [m^3/s^2]: nu int omega t ds of the same vorticity, each
///            core's integral along the wall in closed form, nothing smoothed
/// moment     of it about the origin, anticlockwise [m^4/s^2]: nu int omega x.n ds
///
/// A wall that turns at the rate Omega is sheared by omega - 2 Omega only, since what turns as a
/// whole shears nothing: that leaves the force as it is, and takes 4 nu Omega A from the moment.
struct WallShear {
  std::vector<double> vorticity;
  Vec2 friction;
  double moment = 0;

  WallShear& operator+=(const WallShear& other);
};

/// What blobs shear the wall with: the sum of the folded cores' vorticity there, and that of the
/// sheet which the last step of dt has let in at an even rate (its blobs not among the others yet).
///
/// By an even rate gamma/dt, n steps make 2 gamma/sqrt(pi nu dt) sqrt(n); the cores of sigma_0
/// released at the ends of those before the last have sum_k 2 gamma/sqrt(pi (sigma_0^2 + 4 k nu
/// dt)), k = 1 .. n - 1. The last sheet counts as what is missing, for n large:
///
///   -zeta(1/2, 1 + sigma_0^2/(4 nu dt)) gamma/sqrt(pi nu dt),   zeta of Hurwitz
///
/// which is 2.02 for sigma_0^2 = 2 nu dt, cores of the mean age, and 1.76 for nu dt.
///
/// found  wall points nearest to the blobs' centres
WallShear wall_shear(const Blobs& blobs, std::span<const double> sheet, const Wall& wall, double nu,
                     double dt, double sigma_0, const WallPoints& found = WallPoints());

/// Pressure force of the fluid on a body at rest (or in its frame, motion.hpp), per unit density
/// [m^3/s^2], from the sheet that one step of dt had to release:
///
///   dp/ds = -gamma/dt,   F = -int p n ds = (-sum gamma b y, sum gamma b x)/dt
///
/// source  Koumoutsakos & Leonard, J. Fluid Mech. 296 (1995)
Vec2 pressure_force(std::span<const double> sheet, const Wall& wall, double dt);

/// Its moment about the origin, anticlockwise [m^4/s^2]:
///
///   M = int p x.t ds = -1/2 int |x|^2 dp/ds ds = sum gamma b |x|^2/(2 dt)
double pressure_moment(std::span<const double> sheet, const Wall& wall, double dt);

}  // namespace vortree::vortex
