#pragma once

#include "vortex/step.hpp"

namespace vortree::vortex {

/// Releases, as blobs of this core, the sheet that cancels the slip at a time, and tells what acts
/// on the bodies in the step that ends then.
///
/// impulsive  the slip has come about at once, and so has the sheet, on the wall
/// found      wall points nearest to the blobs' centres
Wake cancel_slip(Blobs& blobs, const WallPoints& found, const Problem& p, double time, double core,
                 bool impulsive);

}  // namespace vortree::vortex
