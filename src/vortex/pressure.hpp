#pragma once

#include <span>
#include <vector>

#include "vortex/step.hpp"

namespace vortree::vortex {

/// What the wall tells of the pressure beside it, a value a panel.
///
/// slope      dp/ds in the body's own frame (slope_at_end of wall_pressure.hpp)
/// vorticity  Wake::wall_vorticity [1/s]
struct WallData {
  std::span<const double> slope, vorticity;
};

/// Pressure at points of the fluid beyond that far away, per unit density [m^2/s^2]; 0 within a
/// body.
///
/// By the momentum equation in the form of Lamb and Gromeka
///
///   grad h = u x omega - du/dt - nu curl omega,   h = p + |u|^2/2 - |U|^2/2 -> 0 far away,
///
/// U the stream and u the velocity as the body's centre sees them, so that lap h = div(u x omega).
/// Green's third identity with G = ln r/(2 pi), integrated by parts, makes of it a sum of dipoles,
///
///   h(x) = 1/(2 pi) int F (x - x')/r^2 dA + 1/(2 pi) oint (mu n - lambda t) (x - x')/r^2 ds,
///   F = u x omega = omega (v, -u),   mu = P + rate^2 |x|^2/2,   lambda = nu omega - rate' |x|^2/2,
///
/// n out of the body, t anticlockwise, P the pressure along the wall in the frame of the body's
/// centre: on a wall that moves as a rigid body
///
///   n (grad h - F) = -n (X'' + rate' e x x) - nu d omega/ds,
///
/// and X'' n, integrated with the harmonic X'' x, makes p there that in the frame. Constants of mu
/// and lambda are seen by nothing outside: how the pressure rises along the wall is enough, its
/// level follows (wall_pressure.hpp has another way to it). No rate of change of the field is
/// needed, and without a wall the first integral is all.
///
/// Where bodies move against each other, V and rate those of one of them in the frame of all, x
/// from its centre, its mu has (V' - 2 rate e x V) x beside that: |u|^2/2 of its wall, and what
/// drives the fluid there, V' - rate e x V.
///
/// A blob is a dipole gamma (v, -u), u the mean velocity over its core, smoothed as its velocity
/// is; and a quadrupole, of how u changes across the core: without it the middle of a vortex would
/// miss some omega^2 core^2/4.
///
/// along   of a wall; without one nothing is read of it
/// error   O(core^4) in free space: 8e-3 of the least pressure in a vortex four times as wide as
///         its cores; beside a wall that of their fold, too, and that of the slope
///         (tests/vortex/pressure.cpp)
/// cost    a velocity of all blobs with its gradient; at the points three velocities and two
///         gradients
/// throws  std::invalid_argument if the wall has another number of panels
/// source  Uhlman, NUWC-NPT Technical Report 10086 (1992), for the pressure from vorticity by a
///         boundary integral
std::vector<double> pressure_at(tree::Points points, const Blobs& blobs, const Problem& problem,
                                const WallData& along = {});

}  // namespace vortree::vortex
