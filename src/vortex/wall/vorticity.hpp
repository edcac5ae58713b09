#pragma once

#include <span>

#include "body/shape.hpp"
#include "tree/order/points.hpp"
#include "vortex/blobs/blobs.hpp"

namespace vortree::vortex {

/// Vorticity at points of the plane [1/s]: the blobs' Gaussians; next to a wall the folded ones (a
/// blob and its mirror image at the same distance inside); 0 within the body. In free space
/// strained blobs are two halves (cores/halves.hpp).
///
/// error  cores are cut off at 1e-10 of their peaks
void vorticity(const Blobs& blobs, const body::Shape* wall, tree::Points at,
               std::span<double> omega);

}  // namespace vortree::vortex
