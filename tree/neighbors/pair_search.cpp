#include "tree/neighbors/pair_search.hpp"

#include <atomic>
#include <bit>
#include <utility>

#include "tree/base/parallel.hpp"
#include "tree/base/tuning.hpp"
#include "tree/neighbors/candidates.hpp"

namespace vortree::tree {

namespace {

constexpr std::size_t most_kept_registers = kept_candidates / single_count;

// Ranges that touch the one before them become one with it.
void join(std::vector<Range>& ranges) {
  std::size_t count = 0;
  for (const Range range : ranges) {
    if (range.empty()) continue;
    if (count > 0 && ranges[count - 1].last == range.first) {
      ranges[count - 1].last = range.last;
    } else {
      ranges[count++] = range;
    }
  }
  ranges.resize(count);
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
      find_others(group);
      chunk.others.insert(chunk.others.end(), others_.begin(), others_.end());
      chunk.other_count.push_back(static_cast<std::uint32_t>(others_.size()));
      gather(group, others_);
      const auto kept = candidates_.kept();
      chunk.kept.insert(chunk.kept.end(), kept.begin(), kept.end());
      const bool keeps = candidates_.registers() <= most_kept_registers;
      std::vector<kernel::Hits>& hits = keeps ? chunk.hits : hits_;
      if (!keeps) hits.clear();
      for (std::uint32_t local = 0; local < group.own.size(); ++local) {
        const std::size_t at = keeps ? hits.size() : 0;
        hits.resize(at + candidates_.registers() - first_register(local));
        const std::int64_t found = test(local, hits.data() + at);
        length[static_cast<std::size_t>(placed_.id[group.own.first + local])] = found;
        sum += found;
      }
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
      const bool keeps = registers_ <= most_kept_registers;
      if (!keeps) gather(group, ranges);
      row_.renew(pairs_of(group.own, rows) + single_count);
      std::int32_t* next = row_.data();
      for (std::uint32_t local = 0; local < group.own.size(); ++local) {
        const std::size_t first = first_register(local);
        if (!keeps) test_aside(local);
        next = pick(first, keeps ? hits : hits_.data(), next);
        if (keeps) hits += registers_ - first;
      }
      copy_rows(group.own, rows);
    }
  }

  void visit(std::span<const Group> groups, const Chunk& chunk, const RowVisitor& visitor) {
    for (const Group& group : groups.subspan(chunk.first, chunk.last - chunk.first)) {
      find_others(group);
      gather(group, others_);
      find_numbers(group.own, others_, candidates_.kept().data());
      row_.renew((registers_ + 1) * single_count);
      for (std::uint32_t local = 0; local < group.own.size(); ++local) {
        if (test_aside(local) == 0) continue;
        const std::int32_t* end = pick(first_register(local), hits_.data(), row_.data());
        visitor(placed_.id[group.own.first + local], {row_.data(), end});
      }
    }
  }

 private:
  void find_others(const Group& group) {
    others_.clear();
    name_(group, others_);
    join(others_);
  }

  void gather(const Group& group, std::span<const Range> others) {
    if (rule_ == PairRule::max) {
      candidates_.gather<PairRule::max>(placed_, group.own, others, group.length);
    } else if (rule_ == PairRule::mean) {
      candidates_.gather<PairRule::mean>(placed_, group.own, others, group.length);
    } else {
      candidates_.gather<PairRule::own>(placed_, group.own, others, group.length);
    }
  }

  // Numbers in the input of all that a block holds; returns the sets of `kept` that were used.
  std::size_t find_numbers(Range own, std::span<const Range> others, const kernel::Hits* kept) {
    std::size_t room = own.size() + 2 * single_count, count = 0;
    for (const Range range : others) room += range.size();
    numbers_.renew(room);
    const std::size_t used = gather_numbers(placed_.id, own, others, kept, numbers_.data(), count);
    registers_ = (count + single_count - 1) / single_count;
    return used;
  }

  // Where the candidates of an own particle begin: each pair once means with those behind it.
  [[nodiscard]] std::size_t first_register(std::uint32_t local) const {
    return listing_ == Listing::once ? local / single_count : 0;
  }

  // Tests an own particle; itself is no hit, nor, for each pair once, who is before it.
  std::int64_t test(std::uint32_t local, kernel::Hits* hits) {
    const std::size_t first = first_register(local);
    const std::int64_t all =
        rule_ == PairRule::max    ? candidates_.test<PairRule::max>(local, first, hits)
        : rule_ == PairRule::mean ? candidates_.test<PairRule::mean>(local, first, hits)
                                  : candidates_.test<PairRule::own>(local, first, hits);
    const unsigned itself = 1u << local % single_count;
    const unsigned barred = listing_ == Listing::once ? 2 * itself - 1 : itself;
    kernel::Hits& set = hits[local / single_count - first];
    const auto struck = static_cast<unsigned>(set) & barred;
    set = static_cast<kernel::Hits>(set & ~barred);
    return all - std::popcount(struck);
  }

  std::int64_t test_aside(std::uint32_t local) {
    hits_.resize(candidates_.registers());
    return test(local, hits_.data());
  }

  // Writes the numbers of those that were hit, and returns their end.
  std::int32_t* pick(std::size_t first, const kernel::Hits* hits, std::int32_t* to) {
    return kernel::expand(hits, registers_ - first, numbers_.data() + first * single_count, to);
  }

  // How many pairs the rows of a group hold. Where they go is anywhere in the input's order: it is
  // fetched meanwhile.
  [[nodiscard]] std::size_t pairs_of(Range own, const PairList& rows) const {
    constexpr std::int64_t line = 64 / sizeof(std::int32_t);
    std::int64_t sum = 0;
    for (std::uint32_t p = own.first; p < own.last; ++p) {
      const auto id = static_cast<std::size_t>(placed_.id[p]);
      const std::int64_t first = rows.start[id], last = rows.start[id + 1];
      for (std::int64_t k = first; k < last; k += line) {
        __builtin_prefetch(rows.index.data() + k, 1);
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
  std::vector<kernel::Hits> hits_;  // of the particle at hand, if they are not kept
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
