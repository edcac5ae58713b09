#include "app/methods/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/methods/vortex.hpp"
#include "base/free_memory.hpp"
#include "checks/warnings/cost.hpp"
#include "checks/warnings/warnings.hpp"
#include "io/input_error.hpp"
#include "io/quote.hpp"
#include "io/scene/scales.hpp"
#include "io/suggestion.hpp"

namespace vortree::app {

std::span<const Method> methods() {
  static const Method all[] = {
      {std::string(io::vortices), vortex_solver, checks::refuse_beyond, checks::warnings}};
  return all;
}

const Method& method_of(const io::Scene& scene, std::span<const Method> among) {
  const auto found = std::ranges::find(among, scene.method, &Method::name);
  if (found != among.end()) return *found;
  std::vector<std::string_view> known;
  for (const Method& one : among) known.push_back(one.name);
  throw io::InputError(fmt::format("{}: method is {}; known: {}", scene.origin.path.string(),
                                   io::quote(io::shortened(scene.method, 60)), io::listed(known)));
}

std::vector<std::string> warnings(const io::Scene& scene, std::span<const Method> among) {
  const Method& method = method_of(scene, among);
  if (method.refuse) method.refuse(scene, machine_memory());
  return method.warnings ? method.warnings(scene) : std::vector<std::string>{};
}

flow::Scales scales_of(const io::Scene& scene) {
  flow::Scales scales;
  scales.body = scene.body.has_value();
  if (scene.body) scales.length = io::length_of(*scene.body);
  if (const double speed = io::speed_of(scene); speed > 0) scales.speed = speed;
  const bool stream = std::hypot(scene.flow.stream[0], scene.flow.stream[1]) > 0;
  if (stream)
    scales.along = io::unit(scene.flow.stream);
  else if (scene.plunge)
    scales.along = io::unit(scene.plunge->direction);
  scales.impulsive = stream || (scene.motion && scene.motion->spin != 0);
  return scales;
}

}  // namespace vortree::app
