#pragma once

#include "flow/flow_case.hpp"
#include "io/tables/fields.hpp"

namespace vortree::flow {

/// Velocity and vorticity on the grid of the scene's [output] window; both 0 within a body.
io::Field picture(double time, const io::SceneOutput& output, const vortex::Blobs& blobs,
                  const FlowCase& flow);

}  // namespace vortree::flow
