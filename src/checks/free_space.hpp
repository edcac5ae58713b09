#pragma once

#include "checks/finished.hpp"

namespace vortree::checks {

// Vortices in free space.

/// The field at the end, against that of a vortex that decays alone.
void check_lamb_oseen(std::vector<Verdict>& list, const Finished& run);

/// Mean rate at which an elliptic vortex turns.
void check_kirchhoff(std::vector<Verdict>& list, const Finished& run);

/// Core over separation when two vortices begin to merge.
void check_merger(std::vector<Verdict>& list, const Finished& run);

/// Way that two opposite vortices have made.
void check_dipole(std::vector<Verdict>& list, const Finished& run);

/// Quadrupole and separation against a reference.
void check_moments(std::vector<Verdict>& list, const Finished& run);

/// What the energy differs from that at the start and what viscosity took.
void check_energy(std::vector<Verdict>& list, const Finished& run);

/// What a flow keeps, from the first row of the report on; beside a body, too.
void check_invariants(std::vector<Verdict>& list, const Finished& run);

}  // namespace vortree::checks
