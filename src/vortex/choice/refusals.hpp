#pragma once

#include "vortex/settings.hpp"

namespace vortree::vortex {

/// What the numbers of a scene, written or chosen, cannot mean to the vortex method:
///
///   cores       sigma_max below sigma_0; wider than half the body's length, beside which nothing
///               would be left of it; no narrower than an initial vortex that they make up
///   diffusion   by other than core spreading beside a body
///   nothing     neither a body nor initial vorticity
///   vortices    nearer than a core, farther apart (or from the body) than 1e5 of them
///   steps       in which a vortex, or vorticity at the wall, turns by more than 100 rad; less than
///               four in a period of the plunge; an exchange of circulation that is unstable
///   tips        that less than half of the panels which the outline needs step over
///   merging.box that does not hold the body, or the initial vorticity
/// throws  Refused
void refuse_senseless(const VortexCase& scene);

}  // namespace vortree::vortex
