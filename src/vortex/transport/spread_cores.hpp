#pragma once

#include "vortex/blobs/blobs.hpp"
#include "vortex/cores/wall_points.hpp"

namespace vortree::vortex {

/// Viscosity by core spreading: sigma^2 += 4 nu dt, the exact solution for a Gaussian, also folded
/// at a flat wall. There the wall takes the tilt V_nt of what stands on it:
///
///   d V_nt/dt = -nu omega(0) m/v_n V_nt,   omega(0) = 2/(sqrt(pi) sigma) exp(-y^2/sigma^2),
///
/// because what is at the wall lies -V_nt m/v_n behind the mean.
///
/// error  of V_nt, whose mean along the wall is taken for linear in the distance: what a constant
///        shear has made of a round core comes out 5 % low when sigma^2 has doubled and 7.5 % when
///        it is fourfold, for a centre on the wall; a tilt left to itself 16 % and 34 %. For a
///        centre two cores away all of these are below 2 %
///
/// found    wall points nearest to the centres
/// returns  the same, with those that the wider cores need
WallPoints spread_cores(Blobs& blobs, double nu, double dt, const body::Shape* wall = nullptr,
                        const WallPoints& found = WallPoints());

}  // namespace vortree::vortex
