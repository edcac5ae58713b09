#pragma once

#include "vortex/blobs/blobs.hpp"

namespace vortree::vortex {

/// Vorticity cut into blobs of width sigma_0 on a square lattice of step h around `centre`. Blobs
/// below `faintest` of the strongest are left out.
struct Lattice {
  Vec2 centre;
  double sigma_0, h;
  double faintest = 1e-12;
};

/// An elliptical Gaussian of half widths a along x and b along y,
///
///   omega = gamma/(pi a b) exp(-x^2/a^2 - y^2/b^2),
///   gamma_ij = gamma h^2/(pi p q) exp(-x_i^2/p^2 - y_j^2/q^2),   p^2 = a^2 - sigma_0^2, q alike,
///
/// which the blobs' own width makes up to the whole again.
/// error   O(exp(-(pi sigma_0/h)^2)) relative; the blobs hold gamma exactly
/// throws  std::invalid_argument unless a, b > sigma_0 > 0 and h > 0
Blobs gaussian_ellipse(const Lattice& lattice, double gamma, double a, double b);

/// The round one: a Lamb-Oseen vortex.
Blobs gaussian_vortex(Vec2 centre, double gamma, double core, double sigma_0, double h);

/// A Gaussian vortex of width a with a quadrupole upon it,
///
///   omega = gamma/(pi a^2) exp(-r^2/a^2) (1 + p (x^2 - y^2)/a^2),
///
/// whose blobs carry exp(-r^2/s^2) (1 + p (a^2/s^4) (x^2 - y^2)) with s^2 = a^2 - sigma_0^2. For p
/// near 1 it becomes a tripole.
/// error   as above
/// source  Rossi, Lingevitch & Bernoff, Phys. Fluids 9 (1997)
Blobs perturbed_vortex(const Lattice& lattice, double gamma, double a, double p);

/// Uniform vorticity gamma/(pi a b) within an ellipse: each blob has the share of its cell that
/// lies inside (16 x 16 points of it). Its edge is as wide as the blobs.
/// throws  std::invalid_argument unless a, b, sigma_0, h > 0
Blobs uniform_ellipse(const Lattice& lattice, double gamma, double a, double b);

}  // namespace vortree::vortex
