#pragma once

#include "io/scene/document.hpp"
#include "io/scene/scene.hpp"

namespace vortree::io {

/// What every number by itself may be, but nobody can mean:
///
///   sizes       beyond 1e30 or, but for 0, below 1e-30, where products of a few leave the doubles
///   nothing     no circulation, or a body at rest in fluid at rest
///   blobs       more than three cores apart
///
/// Held before anything is chosen. throws InputError
void refuse_senseless(const Document& document, const Scene& scene);

/// The same of what may have been chosen:
///
///   vortices    nearer than a core, farther apart (or from the body) than 1e5 of them
///   cores       wider than half the body's length, beside which nothing would be left of it
///   steps       in which a vortex, or vorticity at the wall, turns by more than 100 rad; less than
///               four in a period of the plunge; an exchange of circulation that is unstable
///   tips        of an ellipse or a foil, that panels of more than 12 of their radii step over
///   merging.box that does not hold the body, or the initial vorticity
void refuse_senseless_choice(const Document& document, const Scene& scene);

/// Half the sides of the rectangle, along the axes, that a body just fills, or a little more.
[[nodiscard]] Vec2 half_extent(const body::BodySettings& body);

/// Whether a point lies within a body; for a foil, in the thick of it.
[[nodiscard]] bool covers(const body::BodySettings& body, const Vec2& point);

/// How far from the centre initial vorticity reaches in x and y: three cores beyond the outer ones.
[[nodiscard]] Vec2 half_extent(const vortex::InitialSettings& initial);

}  // namespace vortree::io
