#pragma once

#include <cstddef>
#include <cstdint>

#include "tree/base/tuning.hpp"

/// Numbers that make sums faster or slower and keep every promise: what each trades, and how flat
/// its optimum is. Where nothing is said of the optimum it is not known: the number was not varied.
/// They were chosen on a 2-core EPYC (Zen 3, AVX2); those of threads stand in tree/base/tuning.hpp.
///
/// Where cells meet otherwise, sums differ within the tolerance; for the rest they are the same.
namespace vortree::fmm {

// Where series begin to pay.

/// Points of a childless cell that near sums and series agree on; cells of twice as many split.
/// Larger cells sum more pairs, but fill more of their vectors; smaller ones translate more series,
/// and longer series are dearer. Flat: by the best of five times of 1e4 and 1e5 bare vortices,
/// uniform, ring and wake, and hard, 32 and 40 take 0 and 9 % longer on average than 28 at 1e-3 and
/// 1e-6, 20 and 48 7 and 13 %; below fine_tolerance 28 and 40 take 5 and -2 % longer than 32.
inline constexpr double even_leaf = 28, even_leaf_fine = 32;
inline constexpr double fine_tolerance = 1e-10;
/// The same with cores, unless their reach asks for wider cells. Of fewer it does everywhere in the
/// wake of a cylinder; of 20 or 32 sums with gradients took 2 or 18 % longer there (three frames of
/// 1e4 blobs, best of three times), and as long in clouds of even blobs.
inline constexpr double even_cored_leaf = 16;
/// The most points of a childless cell with cores: near sums with cores share what a vector of
/// sources costs among the points of a cell. Flat: 32, 96 or 128 take 6 % more, 0.3 % fewer and 2 %
/// more instructions than 64 (callgrind of `vortree velocity --threads 1 --tolerance 1e-6
/// --capacity N`, 2e4 random blobs in a square, cores of two spacings).
inline constexpr std::uint32_t cored_capacity = 64;
/// Cells of so few points meet cells and targets apart from them point by point rather than by P2L
/// and M2P.
inline constexpr std::uint32_t few_points = 12;
/// Up to so many near sources a target, cores may refuse series; beyond, `boxes` takes over, which
/// looks at every core by itself.
inline constexpr double most_near_sources = 4000;

/// The most points of a childless cell by boxes. Near sums with cores cost more a pair, but share
/// more of their work among the targets of a leaf; both optima are flat (half to twice the capacity
/// costs less than a tenth).
inline constexpr std::uint32_t boxes_bare_capacity = 64, boxes_cored_capacity = 96;
/// A series of p terms costs as much as 3 + p/2 sources one by one: a start, and half a source a
/// term.
inline constexpr int series_start = 3, terms_a_source = 2;
/// The ratio up to which cells meet by series when the order is chosen by tolerance, the cheapest
/// on average between few terms of small cells and many terms of large ones.
inline constexpr double widest_ratio = 0.65;

/// The most points of a childless cell where vorticities are summed: cells beyond the cores' reach
/// are left out whole, targets of a cell share the rest.
inline constexpr std::uint32_t vorticity_capacity = 32;

/// Cells of fewer points are not asked whether all lie in one place: the
/// question is a pass over them, the answer saves the pairs of a crowd.
inline constexpr std::uint32_t crowd_in_one_place = 256;

// What is done together, so that it is read once and stays in the cache.

/// Sources of a direct sum that all targets visit: four columns of them, 32 KB, and targets that
/// visit them together.
inline constexpr std::size_t sources_a_tile = 1024, targets_a_visit = 64;
/// Into so many visits few targets are shared: each reads all sources.
inline constexpr std::size_t least_visits = 4;
/// Targets of a cell elsewhere that are summed together: more share the search for their sources,
/// in a larger box.
inline constexpr std::size_t targets_a_batch = 64;
/// Targets of neighboring leaves that look for their far cells together, by boxes: more share the
/// search, in a larger box.
inline constexpr std::uint32_t targets_a_block = 256;
/// Points that a series reads at once.
inline constexpr int points_a_series = 64;
/// Points of a cell whose weights are kept between the steps of a sum with cores: a weight is a
/// long chain, and short loops keep more of them going at once.
inline constexpr std::size_t points_a_step = 8;
/// Places of leaves whose sums over each other one thread makes. With cores, where even few points
/// are worth sharing, it is one in so many of all, within bounds: what lies along borders is summed
/// on both sides, and shorter runs would cost a tenth more for it.
inline constexpr std::uint32_t leaf_runs = 8, shortest_leaf_run = 1024, longest_leaf_run = 16384;
/// Points below the finest level that a thread encodes at a time.
inline constexpr std::uint32_t encoded_deep = 512;
/// Cells whose meetings a thread lists at a time, and how many such portions are left to one.
inline const std::uint32_t cells_a_portion = 1024 / tree::sooner;
inline constexpr std::uint32_t portions_for_one = 2;

// Memory is asked for so many steps before it is read: fewer come too late, more crowd the cache.

/// Places of vortices in the order of the tree.
inline constexpr std::size_t gathered_ahead = 48;
/// The same where each is encoded: a step takes longer.
inline constexpr std::size_t encoded_ahead = 32;
/// Cells that near sums will meet.
inline constexpr std::uint32_t cells_ahead = 4;

}  // namespace vortree::fmm
