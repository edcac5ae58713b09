#pragma once

namespace vortree::exact {

/// Fluid at rest around a cylinder of radius R that turns with the rate Omega from t = 0 on; seen
/// from its axis, r >= R, t > 0.
///
///   u_theta(r, t) = Omega R (R/r + 2/pi int_0^inf exp(-nu k^2 t) (J1(kr) Y1(kR) - Y1(kr) J1(kR))
///                                               / (J1(kR)^2 + Y1(kR)^2) dk/k)
///   omega(r, t)   = Omega R  2/pi int_0^inf exp(-nu k^2 t) (J0(kr) Y1(kR) - Y0(kr) J1(kR))
///                                               / (J1(kR)^2 + Y1(kR)^2) dk
///
/// error   2e-8 of Omega R, and of Omega R/sqrt(nu t), at the wall, for nu t from 1e-5 to 10 R^2;
///         to R + 8 sqrt(nu t) as near as its twin goes, 6e-6 (tests/vortex/spin.cpp: the inverse
///         of the Laplace transform; the equation of diffusion itself)
/// cost    two thousand Bessel functions of each kind
/// source  Carslaw & Jaeger, Conduction of Heat in Solids (1959), 13.5, for the modified problem;
///         Lagerstrom, Laminar Flow Theory (1964)
struct SpinningCylinder {
  double rate;    ///< Omega, anticlockwise [1/s]
  double radius;  ///< R [m]
  double nu;      ///< viscosity [m^2/s]

  double swirl(double r, double t) const;  ///< azimuthal velocity, anticlockwise
  double vorticity(double r, double t) const;
};

}  // namespace vortree::exact
