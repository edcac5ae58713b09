#include "tree/radix_sort.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "tree/pieces.hpp"
#include "tree/run_sort.hpp"

namespace vortree::tree {

namespace {

// More buckets than lines of the nearest cache make writing to them slow.
constexpr int most_first_bits = 10, next_bits = 8;

// A bucket is large if it alone would keep a thread busy for so much of its share.
constexpr std::size_t large_part = 4;

Key differing_bits(std::span<const Key> keys) {
  Key differing = 0;
  const Key first = keys[0];
#pragma omp parallel for schedule(static) reduction(| : differing) if (keys.size() > worth_sharing)
  for (std::size_t i = 0; i < keys.size(); ++i) differing |= keys[i] ^ first;
  return differing;
}

Key differing_bits(std::span<const Record> records) {
  Key differing = 0;
  for (const Record& record : records) differing |= record.key ^ records[0].key;
  return differing;
}

// So many bits below the highest one that differs.
struct Digit {
  int low, bits;
  Digit(Key differing, int most)
      : low(std::max(0, static_cast<int>(std::bit_width(differing)) - most)),
        bits(std::min(most, static_cast<int>(std::bit_width(differing)))) {}
  [[nodiscard]] std::size_t count() const { return std::size_t{1} << bits; }
  [[nodiscard]] std::size_t operator()(Key key) const { return key >> low & (count() - 1); }
};

// Moves n things to buckets by their digits. Each portion of them counts for itself, so that
// threads share the work and the order is kept. Returns where each bucket ends.
template <class KeyOf, class Move>
std::vector<std::uint32_t> part(std::size_t n, Digit digit, const KeyOf& key_of, const Move& move) {
  const std::size_t some = pieces_of(n);
  std::vector<std::uint32_t> places(some * digit.count(), 0);
#pragma omp parallel for schedule(static) if (some > 1)
  for (std::size_t p = 0; p < some; ++p) {
    std::uint32_t* counts = &places[p * digit.count()];
    const Range own = piece(n, p, some);
    for (std::size_t i = own.first; i < own.last; ++i) ++counts[digit(key_of(i))];
  }
  std::vector<std::uint32_t> ends(digit.count());
  std::uint32_t next = 0;
  for (std::size_t d = 0; d < digit.count(); ++d) {
    for (std::size_t p = 0; p < some; ++p) {
      next += std::exchange(places[p * digit.count() + d], next);
    }
    ends[d] = next;
  }
#pragma omp parallel for schedule(static) if (some > 1)
  for (std::size_t p = 0; p < some; ++p) {
    std::uint32_t* place = &places[p * digit.count()];
    const Range own = piece(n, p, some);
    for (std::size_t i = own.first; i < own.last; ++i) move(i, place[digit(key_of(i))]++);
  }
  return ends;
}

class Sorter {
 public:
  Sorter(std::span<Key> keys, std::span<std::uint32_t> index)
      : keys_(keys),
        index_(index),
        spare_(std::make_unique_for_overwrite<Record[]>(keys.size())),
        records_(spare_.get(), keys.size()) {
    const auto threads = static_cast<std::size_t>(omp_get_max_threads());
    large_ =
        threads == 1 ? keys.size() : std::max(worth_sharing, keys.size() / (threads * large_part));
  }

  // index_of(i) belongs to key i.
  template <class IndexOf>
  void run(Key differing, const IndexOf& index_of) {
    const std::size_t n = keys_.size();
    const int bits = (static_cast<int>(std::bit_width(n)) + 2) / 2;
    const Digit digit(differing, std::min(most_first_bits, bits));
    const auto ends = part(
        n, digit, [&](std::size_t i) { return keys_[i]; },
        [&](std::size_t i, std::uint32_t to) {
          records_[to] = {keys_[i], index_of(i)};
        });
    collect(0, ends);
    const Key left = differing & ((Key{1} << digit.low) - 1);
#pragma omp parallel if (n > worth_sharing)
    {
      RunSort sort_run;
#pragma omp for schedule(dynamic, 4)
      for (std::size_t b = 0; b < buckets_.size(); ++b) sort(buckets_[b], left, sort_run);
    }
  }

 private:
  // Parts the bucket anew by the next bits that differ.
  std::vector<std::uint32_t> part_again(Range bucket, Key differing) {
    const std::size_t first = bucket.first;
    const auto ends = part(
        bucket.size(), Digit(differing, next_bits),
        [&](std::size_t i) { return records_[first + i].key; },
        [&](std::size_t i, std::uint32_t to) {
          keys_[first + to] = records_[first + i].key;
          index_[first + to] = records_[first + i].index;
        });
#pragma omp parallel for schedule(static) if (bucket.size() > worth_sharing)
    for (std::size_t i = first; i < bucket.last; ++i) records_[i] = {keys_[i], index_[i]};
    return ends;
  }

  // Notes buckets for threads to share; large ones are parted first.
  void collect(std::uint32_t begin, const std::vector<std::uint32_t>& ends) {
    std::uint32_t first = begin;
    for (const std::uint32_t end : ends) {
      const Range bucket{first, begin + end};
      first = bucket.last;
      if (bucket.empty()) continue;
      const Key differing = bucket.size() > large_ ? differing_bits(records(bucket)) : 0;
      if (differing != 0) {
        collect(bucket.first, part_again(bucket, differing));
      } else {
        buckets_.push_back(bucket);
      }
    }
  }

  // `differing` bits may be; whether they do is only asked if they are too many.
  void sort(Range bucket, Key differing, RunSort& sort_run) {
    const int most = RunSort::most_bits(bucket.size());
    const auto few = [=](Key bits) { return static_cast<int>(std::bit_width(bits)) <= most; };
    if (!few(differing)) differing = differing_bits(records(bucket));
    if (few(differing)) {
      sort_run(records(bucket), differing, keys_.subspan(bucket.first, bucket.size()),
               index_.subspan(bucket.first, bucket.size()));
      return;
    }
    std::uint32_t first = bucket.first;
    for (const std::uint32_t end : part_again(bucket, differing)) {
      const Range smaller{first, bucket.first + end};
      first = smaller.last;
      if (!smaller.empty()) sort(smaller, differing, sort_run);
    }
  }

  [[nodiscard]] std::span<const Record> records(Range bucket) const {
    return records_.subspan(bucket.first, bucket.size());
  }

  std::span<Key> keys_;
  std::span<std::uint32_t> index_;
  std::unique_ptr<Record[]> spare_;
  std::span<Record> records_;
  std::vector<Range> buckets_;
  std::size_t large_;
};

}  // namespace

std::vector<std::uint32_t> radix_sort(std::span<Key> keys) {
  std::vector<std::uint32_t> index(keys.size());
  const Key differing = keys.empty() ? 0 : differing_bits(keys);
  if (differing == 0) {
    std::iota(index.begin(), index.end(), 0u);
  } else {
    Sorter(keys, index).run(differing, [](std::size_t i) { return static_cast<std::uint32_t>(i); });
  }
  return index;
}

void radix_sort(std::span<Key> keys, std::span<std::uint32_t> index) {
  if (index.size() != keys.size()) {
    throw std::invalid_argument("radix_sort: " + std::to_string(keys.size()) + " keys but " +
                                std::to_string(index.size()) + " indices");
  }
  const Key differing = keys.empty() ? 0 : differing_bits(keys);
  if (differing == 0) return;
  Sorter(keys, index).run(differing, [&](std::size_t i) { return index[i]; });
}

}  // namespace vortree::tree
