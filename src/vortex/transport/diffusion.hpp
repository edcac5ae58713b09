#pragma once

namespace vortree::vortex {

/// How vorticity diffuses: wider cores that split and merge; blobs that walk at random
/// (random_walk.hpp); blobs that exchange circulation (particle_exchange.hpp). The last two are for
/// free space.
enum class Diffusion { core_spreading, random_walk, particle_exchange };

}  // namespace vortree::vortex
