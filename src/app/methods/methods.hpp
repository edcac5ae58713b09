#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "flow/solver.hpp"
#include "io/scene/scene.hpp"

namespace vortree::app {

/// A method that a scene can name, and how it begins on a scene.
///
/// memory  of the machine [bytes]
struct Method {
  std::string name;
  std::function<std::unique_ptr<flow::Solver>(const io::Scene& scene, const flow::Scales& scales,
                                              double memory)>
      make;
};

/// All that the program has; the first is what a scene gets that names none.
std::span<const Method> methods();

/// throws  io::InputError if there is none of that name
const Method& method_of(const io::Scene& scene, std::span<const Method> among);

/// By the body, stream and motion of a scene.
flow::Scales scales_of(const io::Scene& scene);

}  // namespace vortree::app
