#pragma once

#include <cstddef>
#include <cstdint>

#include "tree/base/waiting.hpp"

/// Numbers that make the tree faster or slower and change no result: what each trades, and how flat
/// its optimum is. Where nothing is said of the optimum it is not known: the number was not varied.
/// They were chosen on a 2-core EPYC (Zen 3, AVX2).
namespace vortree::tree {

// Loops over no more things than these are left to one thread: waking the others costs more than
// they save. One for each kind of loop, here and in fmm.

/// The numbers below are those of threads that sleep between loops; where they look out for the
/// next one so many times fewer things are worth it.
inline const std::uint32_t sooner = threads_sleep() ? 1 : 16;

/// Points to encode, sort and build a tree of. Threads that slept are some 50 microseconds late,
/// and a tree takes ten turns of them: fewer points are done by then.
inline const std::size_t worth_sharing = 150000 / sooner;
/// Points to sort and encode in cells below the finest level.
inline const std::uint32_t deep_points_worth_sharing = 2048 / sooner;
/// Values that one pass reads side by side: extremes, limits.
inline const std::size_t values_worth_sharing = 50000 / sooner;
/// Records that one pass brings together or fetches out of order.
inline const std::size_t records_worth_sharing = 20000 / sooner;
/// Cells, each a matter of some copies and comparisons: kin, frames, bounding boxes, colleagues.
inline const std::uint32_t cells_worth_sharing = 2048 / sooner;
/// Cells, each a matter of its series.
inline const std::uint32_t series_worth_sharing = 512 / sooner;
/// Registers full of families whose multipoles go up to their parents.
inline constexpr std::size_t upward_worth_sharing = 8;
/// The same where expansions come down: 27 translations each, so that two are enough.
inline constexpr std::size_t downward_worth_sharing = 1;

/// Shared work on points comes in so many pieces, whatever the threads: more share more evenly,
/// each has counts of its own.
inline constexpr std::size_t shared_pieces = 16;
/// A piece of a level of fewer cells is not worth its thread, going down from the root.
inline constexpr std::size_t cells_a_piece = 16;

// Sorting by Morton codes. tree/README.md has the time of the whole.

/// Bits of the first parting into buckets. More buckets than lines of the nearest cache make
/// writing to them slow, fewer leave larger ones to sort.
inline constexpr int first_digit_bits = 10;
/// Bits of every further parting, of what is smaller by then.
inline constexpr int next_digit_bits = 8;
/// A bucket of more than one in so many of a thread's share is parted before threads share buckets:
/// one that is not keeps a thread busy when the others are done, parting costs a pass.
inline constexpr std::size_t large_bucket = 8;
/// So many keys with the first bits in common will have more in common than the next few: they are
/// parted by keys picked among them, which costs a search a key and parts any crowd.
inline constexpr std::size_t crowded_keys = 100000;
/// Parts of such a crowd, as a power of two, and keys picked for each: more are more even.
inline constexpr int splitter_levels = 8;
inline constexpr std::size_t picked_a_bucket = 8;
/// Up to this length insertion is faster than counting.
inline constexpr std::size_t insertion_run = 24;
/// Bits that one counting pass within the cache sorts by: its table of counts, 16 KB, stays there.
inline constexpr int run_digit_bits = 12;
/// The same for digit_sort, which counts longer rows, by two bits less than they have numbers: more
/// places to write to than lines of the second cache make writing slow, more than numbers counting.
inline constexpr int least_digit_bits = 6, most_digit_bits = 14;

/// Reaches below a node of the tree that roomy() asks for the least: wide nodes are read more, and
/// there are fewer.
inline constexpr std::size_t reaches_a_node = 16;

// Neighbors. tree/neighbors/README.md has the time of the whole.

/// Particles that stay in the nearest cache while several passes go over them.
inline constexpr std::uint32_t located_at_once = 1024;
/// Cells of no more particles are not worth splitting: their tests cost less than their lists.
inline constexpr std::uint32_t few_particles = 4;
/// So many in a cell below the finest level are searched as fast as they would be parted.
inline constexpr std::uint32_t deep_crowd = 128;
/// Particles that are tested against the same candidates: more share their gathering, in a larger
/// box with more misses.
inline constexpr std::uint32_t largest_group = 64;
/// Particles of a thread's turn: enough to keep it busy, few enough for what they find to stay in
/// its cache.
inline constexpr std::uint32_t particles_a_turn = 2048;
/// Hits among more candidates are not kept but found again: most are misses.
inline constexpr std::size_t kept_candidates = 8192;
/// Lines of memory of a row that are fetched before it is written: none cost 3 to 9 % of a list of
/// shuffled particles, two are as fast as four where rows are short.
inline constexpr std::int64_t fetched_lines = 4;
/// Points of a childless cell at most where balls around places are sought: boxes of cells against
/// distances of points. 8 to 32 cost the same within 15 %, 4 up to 40 % more (1e5 even points,
/// balls of 1 and of 20 of them).
inline constexpr std::uint32_t ball_capacity = 16;
/// Places that a thread takes at a time.
inline constexpr std::size_t ball_portion = 512;

// Memory.

/// One part in so many more than was in use is kept for pieces that are too small just now: memory
/// against fresh pages.
inline constexpr std::size_t spare_memory = 8;

}  // namespace vortree::tree
