#pragma once

#include "flow/warnings.hpp"
#include "sph/settings.hpp"

namespace vortree::sph {

/// What will be poor: spacings that are wide for the layers beside the body or for the wavelength,
/// particles wider than half the body, too little shifting, steps longer than shifting holds, a box
/// near the body, an outlet that the wake meets, a search of all pairs, wishes for finer particles
/// that nothing comes of, vortices thinner than particles.
[[nodiscard]] flow::Warnings warnings(const SphCase& scene);

}  // namespace vortree::sph
