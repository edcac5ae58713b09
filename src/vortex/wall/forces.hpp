#pragma once

#include <span>
#include <vector>

#include "vortex/wall/wall.hpp"

namespace vortree::vortex {

/// What acts on a body, per unit density: a force [m^3/s^2], and its moment about the body's centre
/// (Ring::centre), anticlockwise [m^4/s^2].
struct Load {
  Vec2 force{};
  double moment = 0;

  Load& operator+=(const Load& other);
};
Load operator*(double factor, const Load& load);

/// Of all bodies together, the moment about the wall's origin.
Load total(std::span<const Load> loads, const Wall& wall);

/// vorticity  at the wall, a value a panel [1/s], smoothed along it (along_wall.hpp)
/// friction   of each body: nu int omega t ds of the same vorticity, and nu int omega x.n ds, each
///            core's integral along the wall in closed form, nothing smoothed
///
/// A wall that turns at the rate Omega is sheared by omega - 2 Omega only, since what turns as a
/// whole shears nothing: that leaves the force as it is, and takes 4 nu Omega A from the moment.
struct WallShear {
  std::vector<double> vorticity;
  std::vector<Load> friction;

  WallShear() = default;
  explicit WallShear(const Wall& wall) : vorticity(wall.panels()), friction(wall.rings().size()) {}
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

/// Pressure of the fluid on each body at rest (or in its frame, motion.hpp), from the sheet that
/// one step of dt had to release:
///
///   dp/ds = -gamma/dt,   F = -int p n ds = (-sum gamma b y, sum gamma b x)/dt
///                        M = int p x.t ds = -1/2 int |x|^2 dp/ds ds = sum gamma b |x|^2/(2 dt)
///
/// x being counted from the body's centre.
/// source  Koumoutsakos & Leonard, J. Fluid Mech. 296 (1995)
std::vector<Load> pressure_loads(std::span<const double> sheet, const Wall& wall, double dt);

}  // namespace vortree::vortex
