#pragma once

#include <memory>

#include "flow/solver.hpp"
#include "io/scene/scene.hpp"
#include "vortex/setup.hpp"

namespace vortree::app {

/// A scene as the vortex method takes it.
vortex::Setup vortex_setup(const io::Scene& scene, const flow::Scales& scales);

/// memory  of the machine, which bounds the number of blobs [bytes]
std::unique_ptr<flow::Solver> vortex_solver(const io::Scene& scene, const flow::Scales& scales,
                                            double memory);

}  // namespace vortree::app
