#pragma once

// Numbers of this room that were chosen by measurement.

namespace vortree::sph {

/// Volumes, in those that are wanted, above which a particle splits in two and in four, below which
/// it seeks a partner, and at most with it.
inline constexpr double split_above = 1.9, split_in_four_above = 2.8, merge_below = 0.55,
                        most_merged = 1.5;

/// By how much of the distance particles may widen, around strong vorticity and anywhere.
inline constexpr double steepest = 0.25;

/// How much of the error of a volume is mended in a step, and of its difference to its neighbors'.
inline constexpr double volume_rate = 0.2, evening_rate = 0.1;

}  // namespace vortree::sph
