#pragma once

#include "checks/finished.hpp"

namespace vortree::checks {

/// What a body that plunges feels, held against the scene's [check], over as many whole periods as
/// there are between T = plunge_from and the end (none:
/// not reached).
///
/// morison_*       the force along the plunge, in fluid at rest, as
///
///   F = -D/2 C_D |V| V - pi/4 D^2 C_M dV/dt,   V the body's velocity, per unit density,
///
///                 C_D and C_M by the components of both sides at the frequency of the plunge; C_M
///                 of a cylinder without viscosity is 1
/// theodorsen_max  |C_L - C_L of the plate|/|C_L of the plate|, of the components at the frequency
///                 of the plunge, phases counted; for a plunge across the stream
/// source  Keulegan & Carpenter, J. Res. Nat. Bur. Stand. 60 (1958)
void check_plunge(std::vector<Verdict>& list, const Finished& run);

}  // namespace vortree::checks
