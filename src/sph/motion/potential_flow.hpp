#pragma once

#include "sph/cloud/cloud.hpp"
#include "sph/motion/ambient.hpp"
#include "sph/operators/stencils.hpp"

namespace vortree::sph {

/// The flow that an impulsive start makes, u = U + u_0 + grad phi, u_0 what the particles carry:
///
///   lap phi = 0,   wall   dphi/dn = -n.(U + u_0 - u_wall)
///                  outer  dphi/dn = n.(u_b - U - u_0)
///
/// u_b the stream or, of unbounded fluid, what the sheet on the wall makes there of it and of u_0,
/// u.t ds at each node; found by turns. Nodes of the wall slip.
void start_potential_flow(Cloud& cloud, const Stencils& stencils, const OperatorOptions& options,
                          const Ambient& ambient, bool unbounded);

}  // namespace vortree::sph
