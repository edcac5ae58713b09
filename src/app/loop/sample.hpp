#pragma once

#include "io/tables/fields.hpp"
#include "setup/flow_case.hpp"

namespace vortree::app {

/// Velocity and vorticity on the grid of the scene's [output] window; both 0 within a body.
io::Field picture(double time, const io::SceneOutput& output, const vortex::Blobs& blobs,
                  const setup::FlowCase& flow);

}  // namespace vortree::app
