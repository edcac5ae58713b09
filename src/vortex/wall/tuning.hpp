#pragma once

#include <cstddef>

/// Numbers of the wall: what each trades, and how flat its optimum is. Where nothing is said of the
/// optimum it is not known: the number was not varied.
namespace vortree::vortex {

// The sheet.

/// Integrals over panels are exact for points nearer to the wall than so many panels, and for so
/// many to either side of the nearest: more cost more, fewer miss more. Farther away panels are
/// points, which errs by exp(-2 pi 3) = 7e-9.
inline constexpr double exact_within = 3;
inline constexpr int exact_aside = 6;
/// Farther along the wall cores are felt by so many moments of all that are near a panel: more cost
/// more, fewer miss more of cores that are wider than panels (far_moments.hpp).
inline constexpr int far_moments = 8;
/// Cores that reach so many panels from the wall, or so much of the way to panels far along it, are
/// felt along all panels one by one: fewer cost more, more err more.
inline constexpr double gathered_within = 3.5, gathered_of_clear = 0.6;
/// Of a core's circulation, as the wall sees it, that part which lies aside of its mean
/// (three_points.hpp has the errors): with less of it on longer arms the slip of narrow panels is
/// too smooth, with more too rough. Flat from 0.45 to 0.55.
inline constexpr double least_outer = 0.5;
/// No point that stands for a core is nearer to the wall than so much of the core's mean distance:
/// nearer ones see single panels, farther ones lose more of the tilt of strained cores.
inline constexpr double nearest_of_mean = 0.2;
/// What the multipole of a body's panels leaves out, of sum |gamma|/(2 pi r): terms against digits,
/// far below the tolerances of the other sums.
inline constexpr double disc_tolerance = 1e-10;
/// Up to so many panels are summed one by one for points near the body: of 217, by the fast sum,
/// points would cost four times as much.
inline constexpr std::size_t panels_one_by_one = 600;
/// Registers of points that read the disc's series together: more hide more of its latency, until
/// they spill.
inline constexpr int disc_registers = 3;
/// Points that a thread takes at a time: few are near the wall, and cost more.
inline constexpr int wall_points_a_turn = 512;

// What is read off the wall.

/// The wall vorticity is smoothed over so many panels, against the roughness of blobs a panel apart
/// (along_wall.hpp): more blur boundary layers, of a dozen panels.
inline constexpr double panels_smoothed = 3;
/// At most over so much of the radius of curvature, growing by so much of the way from there.
inline constexpr double smoothed_of_radius = 0.25, steepest_smoothing = 0.25;
/// Widths of a trace beyond which it is left out: exp(-16) = 1.1e-7.
inline constexpr double trace_support = 4;
/// Of a core's peak, where it is cut off in a picture of vorticity.
inline constexpr double core_cut_off = 1e-10;

}  // namespace vortree::vortex
