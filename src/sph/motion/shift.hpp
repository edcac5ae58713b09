#pragma once

#include <vector>

#include "sph/cloud/cloud.hpp"
#include "sph/motion/time_step.hpp"
#include "sph/operators/derivatives.hpp"
#include "sph/operators/stencils.hpp"

namespace vortree::sph {

/// Where particles should go to stand more evenly among their neighbors, without units:
///
///   sum_j (1 - r/(1.5 s_ij))^2 (x_i - x_j)/r,   r < 1.5 s_ij,   s_ij = (s_i + s_j)/2
///
/// of all particles; what coincides with i gives nothing
[[nodiscard]] std::vector<Vec2> repulsions(const Cloud& cloud, const Stencils& stencils);

/// Moves free particles apart by
///
///   min(0.6, strength dt (|grad u| + 0.05 |u|/s)) s repulsion,   at most 0.15 s,
///
/// then along their paths; gives those that stand still, rings and outlet, what the flow
/// brings to them from X = -dt u(X). What
/// is carried follows by Taylor's series to second order.
///
/// slopes   of the cloud as it is, by the stencils
/// source   Xu, Stansby & Laurence, J. Comput. Phys. 228 (2009), for shifting with Taylor's series
void shift_and_move(Cloud& cloud, const Stencils& stencils, const std::vector<Slopes>& slopes,
                    const TimeStep& step, double strength);

/// Moves free particles apart before a flow begins: 0.2 s repulsion, at most 0.1 s.
void spread_evenly(Cloud& cloud, const Stencils& stencils);

}  // namespace vortree::sph
