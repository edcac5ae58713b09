#pragma once

#include <functional>

#include "flow/settings.hpp"
#include "vortex/blobs/velocities.hpp"
#include "vortex/cores/halves.hpp"

namespace vortree::vortex {

/// Velocity and gradient that advect round blobs of free space, so long after the beginning of the
/// step.
using PartsVelocity =
    std::function<Velocities(const Blobs& parts, double after, Gradients& gradients)>;

/// Moves blobs of free space, and strains their cores, for a time dt.
///
///   dX/dt = (u_+ + u_-)/2,   dV/dt = G V + V G^T,   G d = (u_+ - u_-)/2
///
/// with u at the two halves that a strained blob acts as (cores/halves.hpp), each the mean over
/// both cores if velocities are such. Across d the gradient G is the one without divergence that
/// has the mean vorticity of the halves. So the energy of the halves, as Hamiltonian, moves X and
/// V: circulation, impulse, second moment and energy stay, but for the error in time.
///
/// error   O(dt^2) for rk2, O(dt^4) for rk4, per unit of time
/// cost    two, or four, evaluations of the velocity and its gradient at up to two parts a blob
/// source  moments of a blob as a Hamiltonian system: Melander, Zabusky & Styczek, J. Fluid Mech.
///         167 (1986)
void convect_strained(Blobs& blobs, const PartsVelocity& velocity, flow::Scheme scheme, double dt);

}  // namespace vortree::vortex
