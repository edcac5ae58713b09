#pragma once

// Numbers of this room that were chosen by measurement.

namespace vortree::sph {

/// A pivot of a fit below so much of its diagonal: neighbors on a line, or too few.
inline constexpr double least_pivot = 1e-5;

/// A value at a boundary is found by fewer terms if its weights, signs left out, sum up to more:
/// they do where neighbors hardly tell the terms apart, as in a corner that lacks particles.
inline constexpr double most_amplified = 4;

/// Near a boundary fits are of degree 2 and reach so many spacings: fits of degree 4 are unstable
/// there.
inline constexpr double boundary_reach = 2.8;

}  // namespace vortree::sph
