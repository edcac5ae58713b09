#pragma once

#include <span>

#include "vortex/step.hpp"

namespace vortree::vortex {

/// Length of the closed wake behind a body: from the wall, downstream of the body's centre, to the
/// place where the velocity along the stream turns from back to forward; 0 while there is none [m].
///
/// Sampled at points 3 % of their distance apart, between them linear.
/// cost  O(blobs) times some 250 points
double bubble_length(const Blobs& blobs, const Problem& problem);

/// Angle of the main separation from the rear of the body, seen from its centre, mean of both
/// sides; 0 while the flow is attached [degrees].
///
/// Walking from the front along the wall, the place where the wall vorticity first changes its
/// sign, smoothed over a few panels.
double separation_angle(std::span<const double> wall_vorticity, const Wall& wall, Vec2 stream);

}  // namespace vortree::vortex
