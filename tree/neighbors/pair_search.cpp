#include "tree/neighbors/pair_search.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <utility>

#include "tree/base/parallel.hpp"
#include "tree/base/tuning.hpp"
#include "tree/neighbors/candidates.hpp"

namespace vortree::tree {

namespace {

constexpr std::size_t most_kept_registers = kept_candidates / single_count;

// From a place on, ranges that touch the one before them become one with it.
void join(std::vector<Range>& ranges, std::size_t first) {
  Range* end = ranges.data() + first;
  const Range* begin = end;
  for (const Range range : std::span(ranges).subspan(first)) {
    if (range.empty()) continue;
    if (end > begin && end[-1].last == range.first) {
      end[-1].last = range.last;
    } else {
      *end++ = range;
    }
  }
  ranges.resize(static_cast<std::size_t>(end - ranges.data()));
}

// From lengths to where each begins; returns their sum.
std::int64_t add_up(std::span<std::int64_t> start) {
  std::int64_t sum = 0;
  for (std::int64_t& s : start) sum += std::exchange(s, sum);
  return sum;
}

}  // namespace

// One thread at work.
class RowSearch::Pass {
 public:
  Pass(const SortedParticles& placed, const NameCandidates& name, PairRule rule, Listing listing)
      : placed_(placed), name_(name), rule_(rule), listing_(listing) {}

  // Tests all pairs of a chunk, keeps what passed and tells how long each row is, and all together.
  std::int64_t count(std::span<const Group> groups, Chunk& chunk, Buffer<std::int64_t>& length) {
    std::int64_t sum = 0;
    chunk.others.clear(), chunk.other_count.clear(), chunk.kept.clear(), chunk.hits.clear();
    for (const Group& group : groups.subspan(chunk.first, chunk.last - chunk.first)) {
      const std::span<const Range> others = add_others(group, chunk.others);
      chunk.other_count.push_back(static_cast<std::uint32_t>(others.size()));
      gather(group, others, chunk.kept);
      const bool keeps = candidates_.registers() <= most_kept_registers;
      sum += keeps ? count_kept(group.own, chunk.hits, length) : count_only(group.own, length);
    }
    return sum;
  }

  // Writes the rows of a chunk.
  void write(std::span<const Group> groups, const Chunk& chunk, PairList& rows) {
    const Range* others = chunk.others.data();
    const std::uint32_t* other_count = chunk.other_count.data();
    const kernel::Hits *kept = chunk.kept.data(), *hits = chunk.hits.data();
    for (const Group& group : groups.subspan(chunk.first, chunk.last - chunk.first)) {
      const std::span<const Range> ranges{others, *other_count++};
      others += ranges.size();
      kept += find_numbers(group.own, ranges, kept);
      row_.widen(pairs_of(group.own, rows) + single_count);
      if (registers_ <= most_kept_registers) {
        hits = pick_kept(group.own, hits);
      } else {
        pick_again(group, ranges);
      }
      copy_rows(group.own, rows);
    }
  }

  void visit(std::span<const Group> groups, const Chunk& chunk, const RowVisitor& visitor) {
    for (const Group& group : groups.subspan(chunk.first, chunk.last - chunk.first)) {
      others_.clear();
      add_others(group, others_);
      gather_again(group, others_);
      find_numbers(group.own, others_, kept_.data());
      row_.widen((registers_ + 1) * single_count);
      show_rows(group.own, [&](std::uint32_t local, const kernel::Hits* hits, std::int64_t found) {
        if (found == 0) return;
        const std::int32_t* end = pick(first_register(local), hits, row_.data());
        visitor(placed_.id[group.own.first + local], {row_.data(), end});
      });
    }
  }

 private:
  // Appends the ranges of a group's candidates, and returns them.
  std::span<const Range> add_others(const Group& group, std::vector<Range>& others) const {
    const std::size_t before = others.size();
    name_(group, others);
    join(others, before);
    return std::span(others).subspan(before);
  }

  void gather(const Group& group, std::span<const Range> others, Unwritten<kernel::Hits>& kept) {
    if (rule_ == PairRule::max) {
      candidates_.gather<PairRule::max>(placed_, group.own, others, group.length, kept);
    } else if (rule_ == PairRule::mean) {
      candidates_.gather<PairRule::mean>(placed_, group.own, others, group.length, kept);
    } else {
      candidates_.gather<PairRule::own>(placed_, group.own, others, group.length, kept);
    }
  }

  void gather_again(const Group& group, std::span<const Range> others) {
    kept_.clear();
    gather(group, others, kept_);
  }

  // Numbers in the input of all that a block holds; returns the sets of `kept` that were used.
  std::size_t find_numbers(Range own, std::span<const Range> others, const kernel::Hits* kept) {
    std::size_t room = own.size() + 2 * single_count, count = 0;
    for (const Range range : others) room += range.size();
    numbers_.widen(room);
    const std::size_t used = gather_numbers(placed_.id, own, others, kept, numbers_.data(), count);
    registers_ = (count + single_count - 1) / single_count;
    return used;
  }

  // Where the candidates of an own particle begin.
  [[nodiscard]] std::size_t first_register(std::uint32_t local) const {
    return Candidates::first_register(local, listing_);
  }

  kernel::Hits* test(std::size_t first, std::size_t last, kernel::Hits* hits, std::int64_t* found) {
    switch (rule_) {
      case PairRule::max:
        return candidates_.test<PairRule::max>(first, last, listing_, hits, found);
      case PairRule::mean:
        return candidates_.test<PairRule::mean>(first, last, listing_, hits, found);
      default:
        return candidates_.test<PairRule::own>(first, last, listing_, hits, found);
    }
  }

  // Tests all own particles of a group, keeps what passed, and returns how many pairs.
  std::int64_t count_kept(Range own, Unwritten<kernel::Hits>& kept, Buffer<std::int64_t>& length) {
    const std::size_t before = kept.size();
    kept.resize(before + own.size() * candidates_.registers());
    found_.widen(own.size());
    const kernel::Hits* end = test(0, own.size(), kept.data() + before, found_.data());
    kept.resize(static_cast<std::size_t>(end - kept.data()));
    std::int64_t sum = 0;
    for (std::uint32_t local = 0; local < own.size(); ++local) {
      length[static_cast<std::size_t>(placed_.id[own.first + local])] = found_[local];
      sum += found_[local];
    }
    return sum;
  }

  // The same, keeps nothing.
  std::int64_t count_only(Range own, Buffer<std::int64_t>& length) {
    std::int64_t sum = 0;
    show_rows(own, [&](std::uint32_t local, const kernel::Hits*, std::int64_t found) {
      length[static_cast<std::size_t>(placed_.id[own.first + local])] = found;
      sum += found;
    });
    return sum;
  }

  // Tests all own particles of a group, a few at a time, and shows of each which lanes passed, and
  // how many.
  template <class Show>
  void show_rows(Range own, const Show& show) {
    constexpr std::uint32_t few = Candidates::at_once;
    hits_.resize(few * candidates_.registers());
    std::int64_t found[few];
    for (std::uint32_t first = 0; first < own.size(); first += few) {
      const std::uint32_t last = std::min(own.size(), first + few);
      test(first, last, hits_.data(), found);
      const std::size_t of_one = candidates_.registers() - first_register(first);
      for (std::uint32_t local = first; local < last; ++local) {
        show(local, hits_.data() + (local - first) * of_one, found[local - first]);
      }
    }
  }

  // Writes the numbers of those that were hit, and returns their end.
  std::int32_t* pick(std::size_t first, const kernel::Hits* hits, std::int32_t* to) const {
    return kernel::expand(hits, registers_ - first, numbers_.data() + first * single_count, to);
  }

  // Puts all rows of a group together, one after the other; returns the end of its hits.
  const kernel::Hits* pick_kept(Range own, const kernel::Hits* hits) {
    std::int32_t* next = row_.data();
    for (std::uint32_t local = 0; local < own.size(); ++local) {
      const std::size_t first = first_register(local);
      next = pick(first, hits, next);
      hits += registers_ - first;
    }
    return hits;
  }

  // The same for hits that were not kept.
  void pick_again(const Group& group, std::span<const Range> others) {
    gather_again(group, others);
    std::int32_t* next = row_.data();
    show_rows(group.own, [&](std::uint32_t local, const kernel::Hits* hits, std::int64_t) {
      next = pick(first_register(local), hits, next);
    });
  }

  // How many pairs the rows of a group hold. Where they go is anywhere in the input's order: it is
  // fetched meanwhile, of every row as many lines, since how many it takes is not foreseen.
  [[nodiscard]] std::size_t pairs_of(Range own, const PairList& rows) const {
    constexpr std::int64_t line = 64 / sizeof(std::int32_t);
    std::int64_t sum = 0;
    for (std::uint32_t p = own.first; p < own.last; ++p) {
      const auto id = static_cast<std::size_t>(placed_.id[p]);
      const std::int64_t first = rows.start[id], last = rows.start[id + 1];
      for (std::int64_t k = 0; k < fetched_lines; ++k) {
        __builtin_prefetch(rows.index.data() + std::min(first + k * line, last), 1);
      }
      sum += last - first;
    }
    return static_cast<std::size_t>(sum);
  }

  // All rows of a group, only when they are all there: what was just stored in overlapping pieces
  // cannot be loaded at once.
  void copy_rows(Range own, PairList& rows) const {
    const std::int32_t* from = row_.data();
    for (std::uint32_t p = own.first; p < own.last; ++p) {
      const auto id = static_cast<std::size_t>(placed_.id[p]);
      const auto length = static_cast<std::size_t>(rows.start[id + 1] - rows.start[id]);
      kernel::copy_exactly(from, length, rows.index.data() + rows.start[id]);
      from += length;
    }
  }

  const SortedParticles& placed_;
  const NameCandidates& name_;
  PairRule rule_;
  Listing listing_;
  Candidates candidates_;
  std::vector<Range> others_;
  Buffer<std::int32_t> numbers_, row_;  // of all candidates; of those that were hit
  std::size_t registers_ = 0;
  Unwritten<kernel::Hits> kept_, hits_;  // of the particles at hand, if they are not kept
  Buffer<std::int64_t> found_;           // of each own particle
};

void RowSearch::share_out(std::span<const Group> groups) {
  std::size_t count = 0, first = 0;
  std::uint32_t particles = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    particles += groups[g].own.size();
    if (particles < particles_a_turn && g + 1 < groups.size()) continue;
    if (count == chunks_.size()) chunks_.emplace_back();
    chunks_[count].first = first;
    chunks_[count++].last = first = g + 1;
    particles = 0;
  }
  chunks_.resize(count);
}

void RowSearch::list(const SortedParticles& placed, std::span<const Group> groups,
                     const NameCandidates& name, PairRule rule, Listing listing, PairList& rows) {
  share_out(groups);
  rows.start.renew(placed.size + 1);
  rows.start[placed.size] = 0;
  Thrown thrown;
  std::atomic<std::int64_t> pairs = 0;
#pragma omp parallel
  {
    Pass pass(placed, name, rule, listing);
#pragma omp for schedule(dynamic)
    for (Chunk& chunk : chunks_) {
      thrown.guard([&] {
        pairs += pass.count(groups, chunk, rows.start);
        if (pairs > rows.most) rows.refuse(pairs);
      });
    }
#pragma omp single
    thrown.guard([&] { rows.make_room(add_up(rows.start.span())); });
#pragma omp for schedule(dynamic)
    for (Chunk& chunk : chunks_) thrown.guard([&] { pass.write(groups, chunk, rows); });
  }
  thrown.rethrow();
}

void RowSearch::visit(const SortedParticles& placed, std::span<const Group> groups,
                      const NameCandidates& name, PairRule rule, Listing listing,
                      const RowVisitor& visitor) {
  share_out(groups);
  Thrown thrown;
#pragma omp parallel
  {
    Pass pass(placed, name, rule, listing);
#pragma omp for schedule(dynamic)
    for (Chunk& chunk : chunks_) thrown.guard([&] { pass.visit(groups, chunk, visitor); });
  }
  thrown.rethrow();
}

std::size_t RowSearch::bytes() const {
  std::size_t sum = chunks_.capacity() * sizeof(Chunk);
  for (const Chunk& chunk : chunks_) {
    sum += chunk.others.capacity() * sizeof(Range) +
           chunk.other_count.capacity() * sizeof(std::uint32_t) +
           (chunk.kept.capacity() + chunk.hits.capacity()) * sizeof(kernel::Hits);
  }
  return sum;
}

}  // namespace vortree::tree
