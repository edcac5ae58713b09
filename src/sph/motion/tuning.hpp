#pragma once

// Numbers of this room that were chosen by measurement.

namespace vortree::sph {

/// A shift is at most so much of the spacing times the repulsion, and so many spacings.
inline constexpr double most_shift = 0.6, longest_shift = 0.15;

/// A pressure without a given value anywhere: lap p - pin/area p.
inline constexpr double pin = 1e-4;
inline constexpr int most_iterations = 400;
inline constexpr double viscous_tolerance = 1e-7;

/// How much of an alternating velocity beside the outer boundary goes in a step: more than the
/// tenth or two by which it grows.
inline constexpr double edge_filter = 0.3;

/// Up to so many spacings particles of the starting lattice are off their places.
inline constexpr double start_disorder = 0.1;

/// Steps in which a starting lattice is spread.
inline constexpr int spreading_steps = 60;

/// Of the potential at the start.
inline constexpr double start_tolerance = 1e-7;

/// Beside sides of the box without an outlet, within this share of its shorter side, vorticity does
/// not count for the far field.
inline constexpr double edge_share = 0.15;

/// The first step from an impulsive start, in those of the scene, and how fast steps may grow from
/// there.
inline constexpr double first_step = 0.1, step_growth = 1.2;

/// Steps are shortened where a particle would move more than so many Courant numbers: fluid is up
/// to twice as fast beside a body as the stream.
inline constexpr double largest_courant = 4;

/// In parts of a step that are so much shorter nobody goes on: a flow takes some ten of them.
inline constexpr double shortest_step = 1e-3;

/// Particles are sorted again after so many steps.
inline constexpr long sort_every = 5;

/// A flow in which something moves so many times as fast as the stream has broken: at the ends of
/// the thinnest body that is computed, ten times as long as thick, potential flow is eleven times
/// as fast.
inline constexpr double most_speed = 30;

}  // namespace vortree::sph
