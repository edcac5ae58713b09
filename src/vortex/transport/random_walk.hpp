#pragma once

#include <cstdint>

#include "vortex/blobs/blobs.hpp"

namespace vortree::vortex {

/// Diffusion by chance: each blob steps by two independent normal numbers of variance 2 nu dt, in
/// place of wider cores.
///
/// The numbers are a hash of seed, step and the blob's place in the list: runs repeat bit for bit.
/// error   of any mean over n blobs O(n^-1/2), whatever dt; circulation is exact, impulse is not
/// source  Chorin, J. Fluid Mech. 57 (1973)
void random_walk(Blobs& blobs, double nu, double dt, std::uint64_t seed, std::uint64_t step);

}  // namespace vortree::vortex
