#pragma once

#include <span>

#include "fmm/blobs.hpp"

namespace vortree::fmm {

/// Velocity of all blobs at the targets, every pair summed.
///
///   u_i = sum_j gamma_j/(2 pi) (1 - exp(-r^2/S)) / r^2 (-dy, dx),  (dx, dy) = x_i - x_j
///
/// blobs, targets   [m], [m^2/s]; S as Cores says; S = 0 is the bare vortex 1/r^2
/// u, v             as many as targets [m/s]; overwritten
/// error            round-off; pairs at r = 0 contribute nothing
/// cost             O(n m); threads share the targets, the result is the same for any number
/// throws           std::invalid_argument as check(blobs), check(targets), check_result
void velocity_direct(const Blobs& blobs, const Targets& targets, Cores cores, std::span<double> u,
                     std::span<double> v);

}  // namespace vortree::fmm
