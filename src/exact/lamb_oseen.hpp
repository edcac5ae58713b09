#pragma once

namespace vortree::exact {

/// A vortex that decays by viscosity alone (Oseen 1911; Lamb 1932), centred at the origin.
///
///   omega(r, t) = gamma/(pi s^2) exp(-r^2/s^2),   s^2 = s_0^2 + 4 nu t
///   u_theta(r, t) = gamma/(2 pi r) (1 - exp(-r^2/s^2))
///   int omega r^2 dA = gamma s^2,  growing by exactly 4 nu gamma per unit of time
struct LambOseen {
  double gamma;  ///< circulation [m^2/s]
  double core;   ///< s_0 [m]
  double nu;     ///< viscosity [m^2/s]

  double core_at(double t) const;
  double vorticity(double r, double t) const;
  double swirl(double r, double t) const;  ///< azimuthal velocity, anticlockwise
};

}  // namespace vortree::exact
