#pragma once

#include "sph/boundary/standing_bodies.hpp"
#include "sph/cloud/cloud.hpp"
#include "sph/motion/ambient.hpp"
#include "sph/operators/stencils.hpp"

namespace vortree::sph {

/// The flow that an impulsive start makes, u = U + u_0 + grad phi, u_0 what the particles carry and
/// vortices in the bodies' centres of the circulation that they are to have:
///
///   lap phi = 0,   wall   dphi/dn = -n.(U + u_0 - u_wall)
///                  outer  dphi/dn = n.(u_b - U - u_0)
///
/// u_b the stream or, of unbounded fluid, with that what the particles carry and the sheet on the
/// wall, u.t ds at each node; found by turns. Nodes of the wall slip.
///
/// circulation   of all bodies, shared by their perimeters [L^2/T]
void start_potential_flow(Cloud& cloud, const Stencils& stencils, const OperatorOptions& options,
                          const Ambient& ambient, const StandingBodies& bodies, bool unbounded,
                          double circulation = 0);

}  // namespace vortree::sph
