#include "tree/order/radix_sort.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "tree/base/memory.hpp"
#include "tree/base/parallel.hpp"
#include "tree/base/tuning.hpp"
#include "tree/order/digit_sort.hpp"
#include "tree/order/run_sort.hpp"

namespace vortree::tree {

namespace {

MortonKey key_of(MortonKey key) {
  return key;
}
MortonKey key_of(const Record& record) {
  return record.key;
}

template <class Keyed>
MortonKey differing_bits(std::span<const Keyed> all) {
  const std::size_t pieces = pieces_of(all.size());
  const MortonKey first = key_of(all[0]);
  std::array<MortonKey, shared_pieces> found{};
  for_each_piece(pieces, [&](std::size_t p) {
    const Range own = piece(all.size(), p, pieces);
    MortonKey differing = 0;
    for (const Keyed& one : all.subspan(own.first, own.size())) differing |= key_of(one) ^ first;
    found[p] = differing;
  });
  return std::accumulate(found.begin(), found.end(), MortonKey{0}, std::bit_or());
}

// At most so many bits, from the highest one that differs.
Digit highest_digit(MortonKey differing, int most) {
  const int width = std::bit_width(differing);
  return {std::max(0, width - most), std::min(most, width)};
}

// Numbers keys by where they stand among some of them, picked so that buckets come out about
// equally full however the keys crowd. A key that was picked twice has a bucket of its own.
class Splitters {
 public:
  explicit Splitters(std::span<const Record> records) {
    std::array<MortonKey, picked> sample;
    for (std::size_t s = 0; s < picked; ++s) {
      sample[s] = records[s * records.size() / picked].key;
    }
    std::ranges::sort(sample);
    std::array<MortonKey, buckets - 1> bounds;
    bounds.fill(~MortonKey{0});
    std::size_t n = 0;
    for (std::size_t s = picked_a_bucket; s < picked; s += picked_a_bucket) {
      const bool twice = sample[s] == sample[s - 1];
      if (n == 0 || sample[s] > bounds[n - 1]) bounds[n++] = sample[s];
      if (twice && sample[s] >= bounds[n - 1] && sample[s] != ~MortonKey{0})
        bounds[n++] = sample[s] + 1;
    }
    plant(bounds, 0, 1);
  }

  [[nodiscard]] static std::size_t count() { return buckets; }
  // The number of bounds that are not above a key, down a binary tree.
  [[nodiscard]] std::size_t operator()(MortonKey key) const {
    std::size_t place = 1;
#pragma GCC unroll 8
    for (int level = 0; level < splitter_levels; ++level) place = 2 * place + (key >= tree_[place]);
    return place - buckets;
  }

 private:
  static constexpr std::size_t buckets = 1 << splitter_levels;
  static constexpr std::size_t picked = buckets / 2 * picked_a_bucket;  // a bucket may become two

  // The bounds from `first` on in order below and at a place of the tree; returns the next one.
  std::size_t plant(const std::array<MortonKey, buckets - 1>& bounds, std::size_t first,
                    std::size_t place) {
    if (place >= buckets) return first;
    first = plant(bounds, first, 2 * place);
    tree_[place] = bounds[first];
    return plant(bounds, first + 1, 2 * place + 1);
  }

  std::array<MortonKey, buckets> tree_;
};

// Moves n things to buckets by their digits. Each portion of them counts for itself, so that
// threads share the work and the order is kept. Returns where each bucket ends.
template <class Digits, class KeyOf, class Move>
std::vector<std::uint32_t> part(std::size_t n, std::size_t some, const Digits& digit,
                                const KeyOf& key_of, const Move& move) {
  std::vector<std::uint32_t> places(some * digit.count(), 0);
  for_each_piece(some, [&](std::size_t p) {
    std::uint32_t* counts = &places[p * digit.count()];
    const Range own = piece(n, p, some);
    for (std::size_t i = own.first; i < own.last; ++i) ++counts[digit(key_of(i))];
  });
  std::vector<std::uint32_t> ends(digit.count());
  std::uint32_t next = 0;
  for (std::size_t d = 0; d < digit.count(); ++d) {
    for (std::size_t p = 0; p < some; ++p) {
      next += std::exchange(places[p * digit.count() + d], next);
    }
    ends[d] = next;
  }
  for_each_piece(some, [&](std::size_t p) {
    std::uint32_t* place = &places[p * digit.count()];
    const Range own = piece(n, p, some);
    for (std::size_t i = own.first; i < own.last; ++i) move(i, place[digit(key_of(i))]++);
  });
  return ends;
}

class Sorter {
 public:
  Sorter(std::span<MortonKey> keys, std::span<std::uint32_t> index)
      : keys_(keys), index_(index), records_(keys.size()) {
    const auto threads = static_cast<std::size_t>(omp_get_max_threads());
    const bool shared = threads > 1 && keys.size() > worth_sharing;
    large_ = shared ? keys.size() / (threads * large_bucket) : keys.size();
  }

  // index_of(i) belongs to key i.
  template <class IndexOf>
  void run(MortonKey differing, const IndexOf& index_of) {
    const std::size_t n = keys_.size();
    const int bits = (static_cast<int>(std::bit_width(n)) + 2) / 2;
    const Digit digit = highest_digit(differing, std::min(first_digit_bits, bits));
    const auto ends = part(
        n, pieces_of(n), digit, [&](std::size_t i) { return keys_[i]; },
        [&](std::size_t i, std::uint32_t to) {
          records_[to] = {keys_[i], index_of(i)};
        });
    collect(0, ends);
    const MortonKey left = differing & ((MortonKey{1} << digit.low) - 1);
    share_in_turn(
        all_of(buckets_.size()), 4, n > worth_sharing, [] { return RunSort(); },
        [&](std::uint32_t b, RunSort& sort_run) { sort(buckets_[b], left, sort_run); });
  }

 private:
  // Parts a bucket anew so that no part is all of it: a crowd by splitters, few by the next bits
  // that differ.
  std::vector<std::uint32_t> part_again(Range bucket, MortonKey differing, std::size_t some) {
    return bucket.size() > crowded_keys
               ? part_by(Splitters(records(bucket)), bucket, some)
               : part_by(highest_digit(differing, next_digit_bits), bucket, some);
  }

  template <class Digits>
  std::vector<std::uint32_t> part_by(const Digits& digits, Range bucket, std::size_t some) {
    const std::size_t first = bucket.first;
    const auto ends = part(
        bucket.size(), some, digits, [&](std::size_t i) { return records_[first + i].key; },
        [&](std::size_t i, std::uint32_t to) {
          keys_[first + to] = records_[first + i].key;
          index_[first + to] = records_[first + i].index;
        });
    share_evenly(bucket, some > 1, [&](std::uint32_t i) { records_[i] = {keys_[i], index_[i]}; });
    return ends;
  }

  // Notes buckets for threads to share; large ones are parted first.
  void collect(std::uint32_t begin, const std::vector<std::uint32_t>& ends) {
    std::uint32_t first = begin;
    for (const std::uint32_t end : ends) {
      const Range bucket{first, begin + end};
      first = bucket.last;
      if (bucket.empty()) continue;
      const MortonKey differing = bucket.size() > large_ ? differing_bits(records(bucket)) : 0;
      if (differing != 0) {
        collect(bucket.first, part_again(bucket, differing, shared_pieces));
      } else {
        buckets_.push_back(bucket);
      }
    }
  }

  // `differing` bits may be; whether they do is only asked if they are too many.
  void sort(Range bucket, MortonKey differing, RunSort& sort_run) {
    const int most = RunSort::most_bits(bucket.size());
    const auto few = [=](MortonKey bits) {
      return bits == 0 ||
             (bucket.size() <= crowded_keys && static_cast<int>(std::bit_width(bits)) <= most);
    };
    if (!few(differing)) differing = differing_bits(records(bucket));
    if (few(differing)) {
      sort_run(records(bucket), differing, keys_.subspan(bucket.first, bucket.size()),
               index_.subspan(bucket.first, bucket.size()));
      return;
    }
    std::uint32_t first = bucket.first;
    for (const std::uint32_t end : part_again(bucket, differing, 1)) {
      const Range smaller{first, bucket.first + end};
      first = smaller.last;
      if (!smaller.empty()) sort(smaller, differing, sort_run);
    }
  }

  [[nodiscard]] std::span<const Record> records(Range bucket) const {
    return std::span(records_).subspan(bucket.first, bucket.size());
  }

  std::span<MortonKey> keys_;
  std::span<std::uint32_t> index_;
  Unwritten<Record> records_;
  std::vector<Range> buckets_;
  std::size_t large_;
};

}  // namespace

Unwritten<std::uint32_t> radix_sort(std::span<MortonKey> keys) {
  Unwritten<std::uint32_t> index(keys.size());
  const MortonKey differing = keys.empty() ? 0 : differing_bits(std::span<const MortonKey>(keys));
  if (differing == 0) {
    std::iota(index.begin(), index.end(), 0u);
  } else {
    Sorter(keys, index).run(differing, [](std::size_t i) { return static_cast<std::uint32_t>(i); });
  }
  return index;
}

void radix_sort(std::span<MortonKey> keys, std::span<std::uint32_t> index) {
  if (index.size() != keys.size()) {
    throw std::invalid_argument("radix_sort: " + std::to_string(keys.size()) + " keys but " +
                                std::to_string(index.size()) + " indices");
  }
  const MortonKey differing = keys.empty() ? 0 : differing_bits(std::span<const MortonKey>(keys));
  if (differing == 0) return;
  Sorter(keys, index).run(differing, [&](std::size_t i) { return index[i]; });
}

}  // namespace vortree::tree
