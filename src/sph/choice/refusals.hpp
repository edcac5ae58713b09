#pragma once

#include "sph/settings.hpp"

namespace vortree::sph {

/// throws  Refused for what SPH cannot compute, or nobody can mean: no body, fluid without
///         viscosity, initial vortices within the body or outside of the box, a body that plunges
///         upstream as fast as that; a reach that does not go with the degree; spacings wider than
///         a fifth of the body or half its thickness; a zone narrower than the rings; a box that
///         does not hold the body, its rings and two of the widest spacings, or in which those are
///         not reached; a periodic box with a body, without a flow that fills the plane, or of
///         other sides than whole wavelengths; regions that are not finer, or finer than the body's
///         particles, or that reach a side of the box
void refuse_senseless(const SphCase& scene);

/// throws  Refused, with the numbers, for more particles than memory holds [bytes]
void refuse_beyond(const SphCase& scene, double memory);

}  // namespace vortree::sph
