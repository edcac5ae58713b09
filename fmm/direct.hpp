#pragma once

#include <span>

#include "fmm/sources.hpp"

namespace vortree::fmm {

/// Velocity of all blobs at the targets, every pair summed.
///
///   u_i = sum_j gamma_j/(2 pi) (1 - exp(-r^2/S)) / r^2 (-dy, dx),  (dx, dy) = x_i - x_j
///
/// sources, targets   [m], [m^2/s]; S as Cores says; S = 0 is the bare vortex 1/r^2
/// u, v               as many as targets [m/s]; overwritten
/// error              round-off; pairs at r = 0 contribute nothing
/// cost               O(n m); threads share the targets, the result is the same for any number
/// throws             std::invalid_argument as check(sources), check(targets), check_result
void velocity_direct(const Sources& sources, const Targets& targets, Cores cores,
                     std::span<double> u, std::span<double> v);

/// How it changes from place to place there: the formulas of Plan::gradient, every pair summed.
///
/// ux, uy, vx   as many as targets [1/s]; overwritten
/// error        round-off; pairs at r = 0 contribute the rotation of the core, nothing if bare
/// cost, throws as velocity_direct
void gradient_direct(const Sources& sources, const Targets& targets, Cores cores,
                     std::span<double> ux, std::span<double> uy, std::span<double> vx);

/// The stream function of Plan::stream_function, every pair summed.
///
/// psi     as many as targets [m^2/s]; overwritten
/// error   round-off; bare pairs at r = 0 contribute nothing
/// cost, throws as velocity_direct
void stream_function_direct(const Sources& sources, const Targets& targets, Cores cores,
                            std::span<double> psi);

}  // namespace vortree::fmm
