#pragma once

#include "vortex/blobs/blobs.hpp"

namespace vortree::vortex {

/// Energy of blobs in free space and how fast viscosity takes it.
///
///   energy    = (1/2) int omega psi dA = -(1/4 pi) sum_ij gamma_i gamma_j (ln r + E_1(r^2/s^2)/2)
///   enstrophy = int omega^2 dA = sum_ij gamma_i gamma_j exp(-r^2/s^2)/(pi s^2)
///
/// with r = |x_i - x_j| and s^2 = sigma_i^2 + sigma_j^2 (r -> 0: (ln s^2 - 0.5772)/2 in the
/// brackets), strained blobs as two halves (cores/halves.hpp); per unit density [m^4/s^2] and
/// [m^2/s^2]. Of circulation zero, the first is the kinetic energy; else it is that but for an
/// infinite constant. d(energy)/dt = -nu enstrophy.
/// cost  O(blobs^2)
struct Energy {
  double energy, enstrophy;
};

Energy energy(const Blobs& blobs);

}  // namespace vortree::vortex
