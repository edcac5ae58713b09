#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "flow/warnings.hpp"
#include "vortex/settings.hpp"

namespace vortree::vortex {

/// What a run will ask of the machine, before it runs: from the area that vorticity will fill, in
/// cores of sigma_max, and from what a blob and a panel were measured to take.
///
///   steps    time.end/time.dt
///   blobs    most at one time; past a body layer and wake (as far as merging.box lets it go), in
///            free space the spreading vortex; all that splits, where nothing merges
///   bytes    of blobs, of the wall's matrix and of the largest picture together
///   setup    seconds before the first step: the wall's matrix, cut into factors
///   seconds  of the whole run, on one thread of an idle machine
///
/// error  a factor of three for blobs and bytes; of ten for seconds
struct Cost {
  double steps = 0, blobs = 0, wall_bytes = 0, bytes = 0, setup = 0, seconds = 0;
};
Cost cost_of(const VortexCase& scene);

/// Blobs that so many bytes hold.
std::size_t blobs_in(double bytes);

/// A sentence for each cost that somebody may not have meant: more than an hour, more than half the
/// memory, a wall that takes minutes.
flow::Warnings costly(const VortexCase& scene, double memory);

/// throws  Refused, with the numbers, for a scene that needs more memory than there is
void refuse_beyond(const VortexCase& scene, double memory);

}  // namespace vortree::vortex
