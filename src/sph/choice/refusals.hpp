#pragma once

#include "sph/settings.hpp"

namespace vortree::sph {

/// throws  Refused for what SPH cannot compute, or nobody can mean: no body, vorticity to begin
///         with, fluid without viscosity; spacings wider than a fifth of the body; a box that does
///         not hold the body, its rings and two of the widest spacings
void refuse_senseless(const SphCase& scene);

/// throws  Refused, with the numbers, for more particles than memory holds [bytes]
void refuse_beyond(const SphCase& scene, double memory);

}  // namespace vortree::sph
