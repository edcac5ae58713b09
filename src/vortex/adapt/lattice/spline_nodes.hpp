#pragma once

#include <array>
#include <cstdint>

#include "base/vec2.hpp"
#include "vortex/blobs/covariance.hpp"

namespace vortree::vortex {

struct LatticeLevel;

/// The nodes around a blob of free space, strained or not, and the share that each has of its
/// circulation. With M the cubic B-spline, x and y the blob's centre in steps, and V, in steps
/// squared, what its covariance has beyond that of a node's core,
///
///   share_ab = w_a(x) w_b(y) + V_xy M'(x - a) M'(y - b)
///   w_a(x) = M(x - a) + (V_xx - 1/3)/2 M_2(x - a)      (V_yy along y)
///   M_2(x) = -M(x - 2)/12 + 4/3 M(x - 1) - 5/2 M(x) + 4/3 M(x + 1) - M(x + 2)/12,  M'' but smooth
///
/// keep circulation, impulse, all second and all third moments, those of a Gaussian, for any V:
/// thin cores, V < 0, too. Shares have continuous second derivatives (M' a first) by the place:
/// blobs in disorder leave no ripple that a blob in order would not.
///
/// error   of fourth moments, in steps^4: along a line 3 V^2 - 2 V + 11/30 too small, in the mean
///         over all places; 0.054 at V = 1/4, 1/3 at V = 0.03
/// shares  from -0.019 of the blob's own on for round cores of 1/4 <= V <= 1/2; together, each
///         without its sign, up to 1.35 of it. At V = 1/3 none is negative
struct SplineNodes {
  static constexpr int reach = 4, across = 2 * reach + 1;

  std::int64_t gx, gy;                        // the node nearest to the blob
  std::array<double, across * across> share;  // of (gx + a, gy + b) at (a + 4) + 9 (b + 4)

  SplineNodes(Vec2 at, const Core& core, const LatticeLevel& level);
};

}  // namespace vortree::vortex
