#pragma once

#include "flow/initial/settings.hpp"

namespace vortree::flow {

/// Half widths of the initial vortex, or of each of two: across it, and the lesser of both.
[[nodiscard]] double across(const InitialSettings& initial);
[[nodiscard]] double least_width(const InitialSettings& initial);

/// Mean vorticity of the initial vortex, or of each of two, without its sign.
[[nodiscard]] double mean_vorticity(const InitialSettings& initial);

/// How far from the centre initial vorticity reaches in x and y: three cores beyond the outer ones.
[[nodiscard]] Pair half_extent(const InitialSettings& initial);

}  // namespace vortree::flow
