#pragma once

#include "sph/settings.hpp"

namespace vortree::sph {

/// Memory that a particle takes, with its neighbors, weights and rows of both systems.
inline constexpr double bytes_of_particle = 5000;

/// How many particles a flow begins with: the integral of 1/s^2 over the box without bodies, s as
/// wanted, bodies taken for circles of their perimeters; what each region has more, taken for a
/// circle of its area. What vorticity asks for does not count.
/// error  a tenth; regions that overlap count twice, and one whose spacing is that of no level
///        begins with half to twice as many
[[nodiscard]] double expected_particles(const SphCase& scene);

/// The finest that bodies want at the sides of the box nearest to them, taken for circles as above.
[[nodiscard]] double spacing_at_box(const SphCase& scene);

/// The finest that regions want at a node of the box.
[[nodiscard]] double spacing_by_regions_at_box(const SphCase& scene);

/// The larger of the length that a body's coefficients go by and the sides of the rectangle that it
/// fills [L].
[[nodiscard]] double extent_of(const body::BodySettings& body);

/// Mean thickness of the body, its area over its length [L].
[[nodiscard]] double thickness_of(const body::BodySettings& body);

/// The least and the greatest length of a body, by which its coefficients go [L].
struct BodyLengths {
  double shortest, longest;
};
[[nodiscard]] BodyLengths lengths_of(const flow::Case& of);

/// The least distance of two walls [L]; infinity of a single body.
[[nodiscard]] double gap_of(const flow::Case& of);

}  // namespace vortree::sph
