#pragma once

#include <span>

#include "fmm/sources.hpp"
#include "tree/order/points.hpp"

namespace vortree::fmm {

/// Vorticity of the blobs at the targets, for pictures and checks.
///
///   omega(x) = sum_j gamma_j / (pi sigma_j^2) exp(-|x - X_j|^2 / sigma_j^2)
///
/// sources  as check() asks; those with sigma = 0 are points without extent and left out
/// omega    as many as targets [1/s]; overwritten
/// error    blobs farther than sigma_j sqrt(ln(1/tolerance)) are left out, each with at most
///          tolerance times its own peak; all of them together miss about tolerance times the
///          largest sum of |contributions| anywhere
/// cost     O(n + m) for even cores: every target meets the blobs within reach of its leaf
/// throws   std::invalid_argument as check(sources) and check(targets); if omega does not fit;
///          unless 0 < tolerance < 1
void vorticity(const Sources& sources, tree::Points targets, std::span<double> omega,
               double tolerance = 1e-6);

}  // namespace vortree::fmm
