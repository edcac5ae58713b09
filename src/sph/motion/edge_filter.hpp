#pragma once

#include <vector>

#include "sph/cloud/cloud.hpp"
#include "sph/operators/derivatives.hpp"
#include "sph/operators/stencils.hpp"

namespace vortree::sph {

/// Takes from velocities beside the outer boundary what alternates from particle to particle:
///
///   u_i <- u_i + share sum_j w_ij (u_j - u_i - change_i(x_j - x_i)) / sum_j w_ij
///
/// for free particles that see a node of it; change_i is Taylor's series to second order, of pair
/// sums to first, w_ij the weights of Stencils, as far as fits reach beside a boundary. With fits
/// of degree 4 those are left out that are far enough for them. Polynomials of second degree stay
/// as they are, with pair sums those of first. There a pressure that is
/// given, or follows from few neighbors, answers a velocity that alternates along the boundary with
/// the wrong sign, since fits do not see it: (1 - D G/L) u is up to 1 + (k d)^-2 u, d the distance
/// and k the wave number.
void filter_edges(Cloud& cloud, const Stencils& stencils, const std::vector<Slopes>& slopes,
                  const OperatorOptions& options, double share);

}  // namespace vortree::sph
