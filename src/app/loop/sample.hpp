#pragma once

#include "flow/solver.hpp"
#include "io/scene/scene.hpp"
#include "io/tables/fields.hpp"

namespace vortree::app {

/// Velocity, vorticity, stream function and pressure, as far as the method tells them, on the grid
/// of the scene's [output] window; the first two and the last 0 within a body.
io::Field picture(const flow::Solver& solver, const flow::OutputSettings& output);

}  // namespace vortree::app
