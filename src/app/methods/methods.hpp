#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "flow/solver.hpp"
#include "io/scene/scene.hpp"

namespace vortree::app {

/// A method that a scene can name.
///
/// make      begins on a scene, memory of the machine in bytes
/// refuse    throws io::InputError for what is more than the machine can do; may be none
/// warnings  doubts about a scene, before it is run; may be none
struct Method {
  std::string name;
  std::function<std::unique_ptr<flow::Solver>(const io::Scene& scene, const flow::Scales& scales,
                                              double memory)>
      make;
  std::function<void(const io::Scene& scene, double memory)> refuse{};
  std::function<std::vector<std::string>(const io::Scene& scene)> warnings{};
};

/// All that the program has; the first is what a scene gets that names none.
std::span<const Method> methods();

/// throws  io::InputError if there is none of that name
const Method& method_of(const io::Scene& scene, std::span<const Method> among);

/// What the scene's method doubts, a line each.
/// throws  io::InputError if there is no such method, or for more than the machine can do
std::vector<std::string> warnings(const io::Scene& scene, std::span<const Method> among);

/// By the body, stream and motion of a scene.
flow::Scales scales_of(const io::Scene& scene);

}  // namespace vortree::app
