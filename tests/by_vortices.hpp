#pragma once

#include "io/scene/scene.hpp"
#include "vortex/method.hpp"

namespace vortree::test {

/// The vortex method alone, as scenes may name it.
inline const flow::Methods& by_vortices() {
  static const flow::Methods all{flow::AnyMethod(std::make_unique<vortex::VortexMethod>())};
  return all;
}

/// The tables of the vortex method that a scene has.
inline const vortex::VortexSettings& own(const io::Scene& scene) {
  return dynamic_cast<const vortex::VortexMethod&>(scene.computed_by()).settings();
}

inline vortex::VortexCase case_of(const io::Scene& scene) {
  return {scene, own(scene)};
}

}  // namespace vortree::test
