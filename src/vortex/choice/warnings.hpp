#pragma once

#include <string>
#include <vector>

#include "flow/warnings.hpp"
#include "vortex/settings.hpp"

namespace vortree::vortex {

/// What will go wrong with a scene that is valid but asks for too much: a sentence for each
/// setting, with its value, what it will do to the result, and the value that would be right.
///
/// Past a body (diameter D, stream U, boundary layer d = sqrt(nu D/U)):
///   Reynolds  below 20, above 20 000: held against nothing
///   cores     drag error about sigma_max^2/(16 d^2), named from 5 % on
///   time step wall vorticity turns by about 2 U/d dt, named from 2 rad on;
///             around an edge or tip from 15 rad on
///   panels    longer than 6 released cores leave gaps between them; fewer than an outline needs
///             miss how the flow turns around its edges
///   children  of a split that fill 0.66 of the square of what mergers may leave, more where
///             panels are long: the sheet of the start may not settle
///   box       nearer than 7 d and half a D, or than vorticity spreads until the end; than the wake
///             has come by then, 0.4 U t + 6 d, up to 8 D downstream; than 2 d upstream
///   sigma_0   off sqrt(nu dt) by more than 3: wall vorticity, and with it friction, is wrong
/// In free space: the vortex turns by more than 1 rad (rk2: 1/2) a step, cores wider than half the
/// vortex, a lattice wider than 1.4 cores, two vortices that are one.
/// Anywhere: keys of children where there are none, children wider than mergers may be, mergers
/// that may do anything or nothing, sums of few terms (warnings_of_means.hpp); pictures and frames
/// of nothing; what the run will cost (cost.hpp).
flow::Warnings warnings(const VortexCase& scene);

/// Of a scene that writes cores.sigma_max: that an accuracy asked for a vortex in free space, whose
/// error is that of the cores, does not rule it.
void doubt_accuracy(flow::Warnings& list, const VortexCase& scene);

}  // namespace vortree::vortex
