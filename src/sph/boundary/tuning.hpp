#pragma once

#include <cstddef>

// Numbers of this room that were chosen by measurement.

namespace vortree::sph {

/// Particles are taken away nearer than this to the outer boundary, the outermost ring and each
/// other [spacings], and put so far inside where none is nearer than a gap. A gap of 0.95 leaves
/// holes at an inflow that fits do not survive.
inline constexpr double least_depth = 0.35, least_beyond_rings = 0.45, too_close = 0.4,
                        birth_depth = 0.75, gap = 0.8;

/// Vortices of less circulation are not handed to the far field [U D], whose sums err by so much.
inline constexpr double faintest_vortex = 1e-7, far_field_tolerance = 1e-6;

/// Sources of a wall for its unit potentials, where nodes are not as many: solved for in 60 ms.
inline constexpr int enough_sources = 1000;

/// Cores of particles where velocities are asked for among them [spacings].
inline constexpr double core = 1.5;

/// With fewer pairs than this the far field sums them one by one.
inline constexpr std::size_t worth_a_tree = 2'000'000;

}  // namespace vortree::sph
