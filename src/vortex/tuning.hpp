#pragma once

#include <cstddef>
#include <cstdint>

/// Numbers of a run by vortices: what each trades, and how flat its optimum is. Where nothing is
/// said of the optimum it is not known: the number was not varied.
namespace vortree::vortex {

/// Substeps of the first step beside a wall; the last of step n is n/this of it: an impulsive start
/// changes the flow as fast as it is young. Fewer miss how it changes: at Re = 40 with an accuracy
/// of 0.02 the drag of the first eight steps is off by 0.7 % at most, of twelve, with 12, by 0.4 %;
/// to T = 1.6 that takes 1.8 times as long.
inline constexpr std::uint64_t first_substeps = 8;
/// Blobs of less circulation beside a body are let go [U D]: they add up to less than the sums of
/// velocities err by, and would outnumber the others (vortex/blobs/outflow.hpp).
inline constexpr double faintest_kept = 1e-12;
/// Vorticity is faint, times sigma_max, below so much of the merging tolerance: in free space it
/// has coarser lattices (vortex/adapt/lattice/laying.hpp). From 0.02 to 0.1 a free vortex keeps its
/// noise of 0.19 % and its bias, with 0.61 to 0.55 of the blobs; at 1 it has 0.4 %.
inline constexpr double faint_vorticity = 0.05;
/// Cores of a free vortex are strained for so long, times its mean vorticity, until they are laid
/// onto lattices anew. Longer leaves them so long that two halves miss their fourth moments,
/// shorter adds what each lattice errs by: at 10, 4 and 2.4 the quadrupole of gaussian_ellipse with
/// cores of half its width is off by 4, 0.7 and 1.4 %.
inline constexpr double strain_turn = 4;
/// Lattices on account of strain, at most, in the time in which diffusion would ask for one.
inline constexpr double most_layings = 10;
/// What has left the box is felt whole until it is so many times as far as the box, then less and
/// less, until so many times: then nothing changes in a step. As many drift in each doubling of
/// the distance.
inline constexpr double whole_until = 5, felt_until = 10;
/// Drifting vortices merge if the body feels less of it than this share of its speed
/// (vortex/blobs/drifting.hpp): a thousandth of what it feels of one that leaves 25 D behind it.
/// 30 of them drift at Re = 100; how many goes as the inverse cube root.
inline constexpr double merged_unfelt = 1e-5;
/// No more of them drift than so many, whatever the body feels; a wake has a tenth of them.
inline constexpr std::size_t most_drifting = 300;
/// Stream functions are summed to so much of them: between streamlines of a weak vortex beside the
/// wall lie 1e-3 of U R. Digits cost little, for only pictures have them.
inline constexpr double stream_function_tolerance = 1e-7;
/// Blobs of which a frame still tells the energy, a sum over all pairs: 2e8 of them.
inline constexpr std::size_t most_for_energy = 20'000;

/// Blobs that a thread takes at a time, of those that cost more beside the wall than elsewhere:
/// less begins more often, more is shared less evenly.
inline constexpr int blobs_a_turn = 256;

// When blobs multiply faster than they merge (Growth::most): lower bounds end flows that would have
// gone well, higher ones end the others later.

/// Too many are more than so many times as many as before the step, or as five steps before. Flows
/// that went well had 1.9 times as many.
inline constexpr std::size_t too_many_times = 3;
/// In free space all may be laid onto lattices at once, where lone ones become so many nodes.
inline constexpr std::size_t nodes_of_a_blob = 9;
/// But no fewer than so many blobs are too many, against the step before, or five steps before.
inline constexpr std::size_t many_blobs = 20'000, many_of_late = 5000;
/// Besides, for each panel, in the first ten steps beside a wall.
inline constexpr std::size_t many_a_panel = 100;
/// In the first of them: starts that went well had up to 597 a panel, and 143 000 in all; in others
/// nothing had merged at 2370 a panel.
inline constexpr std::size_t many_at_once = 150'000, many_a_panel_at_once = 1000;
/// Children are called nearly too wide to merge from so much on of the square of what mergers may
/// leave.
inline constexpr double wide_children = 0.5;
/// Of both signs beside a body [U D]: an impulsive start has 4, a wake gains less than 1 a diameter
/// of way.
inline constexpr double most_vorticity = 100;

}  // namespace vortree::vortex
