#pragma once

#include "flow/initial/settings.hpp"

// How large an initial flow is, and how fast, for what goes by it. Settings have the numbers of
// their kind (refuse).

namespace vortree::flow {

/// How many vortices there are, alike but for their sign.
[[nodiscard]] std::size_t vortices(const InitialSettings& initial);

/// Half widths of the initial vortex, or of each of two: along x and y, and the lesser of both.
[[nodiscard]] Vec2 half_widths(const InitialSettings& initial);
[[nodiscard]] double least_width(const InitialSettings& initial);

/// Mean vorticity of the initial vortex, or of each of two, without its sign.
[[nodiscard]] double mean_vorticity(const InitialSettings& initial);

/// How far from the centre initial vorticity reaches in x and y: three half widths beyond the outer
/// centres, or one if it ends sharply.
[[nodiscard]] Vec2 half_extent(const InitialSettings& initial);

/// How many blobs of width sigma_0 it is cut into, to a tenth, before that is done.
[[nodiscard]] double lattice_blobs(const InitialSettings& initial, double sigma_0);

/// The vorticity at a place of the scene [1/T].
[[nodiscard]] double vorticity(const InitialSettings& initial, Vec2 at);

}  // namespace vortree::flow
