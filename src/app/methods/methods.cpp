#include "app/methods/methods.hpp"

#include <fmt/format.h>

#include <iterator>

#include "base/free_memory.hpp"
#include "flow/warnings.hpp"
#include "io/input_error.hpp"
#include "io/scene/reference.hpp"
#include "sph/method.hpp"
#include "vortex/method.hpp"

namespace vortree::app {

const flow::Methods& methods() {
  static const flow::Methods all{flow::AnyMethod(std::make_unique<vortex::VortexMethod>()),
                                 flow::AnyMethod(std::make_unique<sph::SphMethod>())};
  return all;
}

flow::Warnings warnings(const io::Scene& scene) {
  const flow::Method& method = scene.computed_by();
  try {
    method.refuse_beyond(scene, static_cast<double>(machine_memory()));
  } catch (const Refused& refused) {
    throw io::InputError(fmt::format("{}: {}", scene.origin.path.string(), refused.what()));
  }
  flow::Warnings list = flow::warnings(scene);
  std::ranges::move(method.warnings(scene), std::back_inserter(list));
  std::ranges::move(io::doubt_references(scene), std::back_inserter(list));
  return list;
}

}  // namespace vortree::app
