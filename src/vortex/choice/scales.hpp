#pragma once

#include "vortex/settings.hpp"

namespace vortree::vortex {

/// Of the panels that an outline needs (body/outlines/panel_limits.hpp) so many have the sheet of a
/// stream right to 4e-4 of its largest, to 2e-3 around the sharpest edges; as many as are needed to
/// 5e-3, 0.75 of them to 5 %; below half hardly its sign is right (measured on ellipses of 5 : 1 to
/// 50 : 1, on foils with edges of 0.0002 to 0.005 chords and on plates).
inline constexpr double enough_panels = 1.5, few_panels = 1, too_few_panels = 0.75,
                        blind_panels = 0.5;

/// The least radius of a tip among the bodies; infinity without any.
[[nodiscard]] double sharpest_tip(const VortexCase& scene);

/// Panels of all bodies.
[[nodiscard]] double panels_of(const VortexCase& scene);

/// sqrt(nu D/U) of the fastest that a body and its stream meet; 0 without viscosity or motion.
[[nodiscard]] double boundary_layer(const VortexCase& scene);

/// Blobs widen, and are split: there is viscosity, and it acts by core spreading.
[[nodiscard]] bool spreads_cores(const VortexCase& scene);

/// Blobs are split into children that must merge lest they multiply: by rings, and around an edge
/// that is too sharp for a lattice along it. Nodes of lattices do not multiply.
[[nodiscard]] bool makes_children(const VortexCase& scene);

/// For how long cores of a free vortex are strained until they are laid onto lattices anew [T]: 4
/// over its mean vorticity. 0 where cores stay round: beside a body, where wide blobs are split by
/// rings, and where diffusion asks for a lattice, each lattice_step^2 sigma_max^2/(8 nu), so seldom
/// that there would be more than `most_layings` for each of those: all of them together would err
/// by more than what strain is worth.
[[nodiscard]] double strained_for(const VortexCase& scene);

/// The cores of a free vortex that an accuracy e calls for: where they are strained, and diffusion
/// lays them often enough, the error is of second order in sigma^2 (choice.hpp has the law).
[[nodiscard]] double widest_in_free_space(const VortexCase& scene, double e);

/// How many times as many blobs merging.tolerance leaves as the one that goes with the cores (past
/// a body U (sigma_max/layer)^2/16, in a free vortex of half width w 0.014 vorticity
/// sigma_max^2/w): as 1/sqrt(tolerance), 1 to 1000; 1 for 0, with which nothing merges. Tolerances
/// of 1/10, 1/100 and 1/1000 left 3.6, 10 and 31 times as many in a free vortex. 1 where there are
/// no children.
[[nodiscard]] double crowding(const VortexCase& scene);

/// By how much vorticity turns in a step [rad]: 2 U dt/layer at the wall, half its vorticity times
/// dt in a free vortex.
[[nodiscard]] double turn_at_wall(const VortexCase& scene);
[[nodiscard]] double turn_of_vortex(const VortexCase& scene);

/// The same at the tips of an ellipse or the edge of a foil, around which a flow across it turns
/// with U sqrt(a/r)/r, a half its length, r the radius there or, if wider, a released core. Up to
/// 13 rad a foil's blobs stayed few; from 20 on they multiplied there.
[[nodiscard]] double turn_at_tip(const VortexCase& scene);

/// The widths of what splits every step [m]: alpha^2 (w^2 + 4 nu dt) = w^2. If the children are too
/// wide to merge, cap sigma_max^2 < w^2, blobs multiply.
[[nodiscard]] double width_of_endless_splits(const VortexCase& scene);
[[nodiscard]] bool splits_endlessly(const VortexCase& scene);

/// How many times in a row a blob splits in such a time, if nothing merges.
[[nodiscard]] double generations(const VortexCase& scene, double time);

}  // namespace vortree::vortex
