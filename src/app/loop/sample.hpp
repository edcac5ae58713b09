#pragma once

#include "flow/solver.hpp"
#include "io/scene/scene.hpp"
#include "io/tables/fields.hpp"

namespace vortree::app {

/// Velocity and vorticity on the grid of the scene's [output] window; both 0 within a body.
io::Field picture(const flow::Solver& solver, const flow::OutputSettings& output);

}  // namespace vortree::app
