#pragma once

#include <string>
#include <vector>

#include "flow/method.hpp"
#include "flow/warnings.hpp"
#include "io/scene/scene.hpp"

namespace vortree::app {

/// All that the program has; the first is what a scene gets that names none.
const flow::Methods& methods();

/// What is doubtful about a scene, a line each.
/// throws  io::InputError for more than the machine can do
flow::Warnings warnings(const io::Scene& scene);

}  // namespace vortree::app
