#pragma once

#include "vortex/blobs/blobs.hpp"

namespace vortree::vortex {

/// Diffusion by exchange of circulation between neighbors of equal area, in place of wider cores:
///
///   d gamma_i/dt = (nu area/epsilon^2) sum_j (gamma_j - gamma_i) eta(x_i - x_j),
///   eta(x) = 4/(pi epsilon^2) exp(-|x|^2/epsilon^2),
///
/// for dt by two terms of the exponential series, gamma + dt A gamma + dt^2/2 A^2 gamma.
///
/// area     of each blob, h^2 of the lattice it was cut from; epsilon > h, or neighbors are missed
/// error    O(epsilon^2) while blobs overlap, O(dt^2); eta is cut off at 5 epsilon. Circulation is
///          exact. The vorticity can only spread to where blobs are
/// throws   std::invalid_argument if nu dt > epsilon^2/2, where it is unstable
/// cost     O(blobs) times the neighbors within 5 epsilon
/// source   Degond & Mas-Gallic, Math. Comput. 53 (1989)
void exchange_strength(Blobs& blobs, double nu, double dt, double epsilon, double area);

}  // namespace vortree::vortex
