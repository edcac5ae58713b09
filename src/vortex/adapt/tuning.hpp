#pragma once

#include <array>
#include <cstddef>

/// Numbers of splits and mergers: what each trades, and how flat its optimum is. Where nothing is
/// said of the optimum it is not known: the number was not varied. Those of the first group say
/// which blobs come and go, within the tolerance of mergers; the others change no result.
namespace vortree::vortex {

// Which blobs there are.

/// Of circulation, for the two children beside a wall that keep their parent's distance from it.
/// Near the 2/3 that a Gaussian's fourth moment would have: with it the errors of one split after
/// the other cancel in the growth of a layer at the wall, to 3e-4 of its mean distance. Not flat:
/// 1e-3 with 0.6 or 0.7.
inline constexpr double usual_share = 0.65;
/// Partners that windows look for are nearer than so many cores, first and then. Farther ones are
/// for weak vorticity, where sigma_max is what limits mergers: taken at a window's border they
/// would leave more blobs.
inline constexpr std::array window_reaches{1.2, 1.5};
/// Tiles of windows move on by so much of their side: no border of a quarter of a tile is one
/// again.
inline constexpr double window_shift = 0.37;
/// A tile's side, in sigma_max, and its cells along a side, which order what windows share: wider
/// tiles part fewer pairs by their borders, smaller ones have less to sort.
inline constexpr double tile_side = 4;
inline constexpr int cells_across = 16;

// Lattices for wide blobs.

/// Step and core of the nodes, in sigma_max. Their ratio of 1.17 is the ripple that a smooth field
/// keeps, 2 exp(-(pi core/step)^2) = 0.15 % a direction; h = s has less of it and 1.3 times the
/// blobs. step^2/2 + core^2 = 0.998 is the least square laid: a little less than sigma_max^2, so
/// that nodes which spread alike go onto the next lattice all at once. With step 1 and core 0.71
/// some went in each step, and two populations lay over each other: 2.2 % noise in a free vortex
/// where these leave 0.19 %.
inline constexpr double lattice_step = 0.9, lattice_core = 0.77;
/// Mergers away from the wall may err by so much of the tolerance. With all of it they bring back
/// the disorder that the lattice took: 3.35 % noise in a free vortex. From 0.01 to 0.3 it is
/// 0.19 %, with 1.36 to 0.84 times the blobs, and the velocity errs by 0.029 to 0.08 %. With none
/// at all each lattice has a row of nodes more around it: 3.4 times the blobs after 100 steps.
inline constexpr double lattice_leniency = 0.1;
/// Faint vorticity in free space has lattices so many times as wide, at most. Fast sums feel the
/// widest core near them: with 4, 5 % fewer blobs took as long.
inline constexpr double faint_widening = 2;
/// Cores are laid along the wall if in no direction they have less than so much of a node's square:
/// thinner ones have negative shares, and lose their fourth moments.
inline constexpr double narrowest_laid = 0.8;
/// Nor if they have spread by more than so many squares of a step in a direction: they would reach
/// more nodes than shares are kept for, 16 to a side.
inline constexpr double widest_laid = 14.4;
/// The lattice along a wall turns with it by so much a step at most [radians]; where it would by
/// more children lie in crosses. It errs by the square: with 0.25 the drag at Re = 1 and 20 was 0.3
/// to 0.4 % low (accuracy 0.01) where it is 0.1 % high.
inline constexpr double sharpest_followed = 0.1;
/// Columns of that lattice, at least and at most.
inline constexpr int least_columns = 8, most_columns = 1 << 18;
/// Of lattices, each a root of two wider than the one before: cores of 2^32 sigma_max.
inline constexpr int most_levels = 64;

// When to give up.

/// Looks at candidates, in the mean of a blob, and in all that a few blobs may take anyway, a
/// second's work. Flows that went well took at most 33 a blob.
inline constexpr std::size_t most_looks = 2000, few_looks = 100'000'000;

// How they are found.

/// Sides of a bin in the longest reach: smaller bins are more runs, wider ones have more candidates
/// out of reach. A search costs least with two or three in its own, and most are shorter.
inline constexpr double bins_a_reach = 4;
/// Bins, and tiles, for a blob at most: where a cloud is thin more would be empty, and are made
/// wider, or share a number.
inline constexpr double bins_a_blob = 16, tiles_a_blob = 4, tiles_anyway = 1024;
/// Who seeks together lies within so many sigma_max: farther apart they have fewer candidates in
/// common.
inline constexpr double seekers_side = 4;
/// Up to so many numbers are sorted by insertion.
inline constexpr std::size_t few_to_sort = 24;

// What a thread takes at a time: less begins more often, more is shared less evenly.

inline constexpr std::size_t seekers_a_turn = 256;
inline constexpr int wall_blobs_a_turn = 32, tiles_a_turn = 16, moved_tiles_a_turn = 256;
/// Up to so many threads are put to better use by a sign each than by what is parallel within one.
inline constexpr int threads_by_sign = 4;

}  // namespace vortree::vortex
