#include "tree/radix_sort.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace vortree::tree {

namespace {

constexpr int digit_bits = 8;
constexpr int most_digits = 4;
constexpr std::size_t buckets = std::size_t{1} << digit_bits;
using Histogram = std::array<std::uint32_t, buckets>;

// Below this length, insertion is faster than counting.
constexpr std::size_t short_run = 32;

// From this length on, pairs are parted among threads.
constexpr std::size_t long_run = 50000;
constexpr std::size_t portions = 8;

struct Pairs {
  std::span<Key> keys;
  std::span<std::uint32_t> index;
  [[nodiscard]] std::size_t size() const { return keys.size(); }
  [[nodiscard]] Pairs part(std::size_t first, std::size_t last) const {
    return {keys.subspan(first, last - first), index.subspan(first, last - first)};
  }
};

std::size_t digit(Key key, int low) {
  return key >> low & (buckets - 1);
}

// A window of bits: so many digits from bit `low` on.
struct Window {
  int low, digits;
};

// As many of the leading bits that differ as leave few keys with the same.
Window leading_window(Key differing, std::size_t n) {
  const int wished = static_cast<int>(std::bit_width(n)) + digit_bits;
  const int digits = std::min(most_digits, (wished + digit_bits - 1) / digit_bits);
  return {std::max(0, static_cast<int>(std::bit_width(differing)) - digits * digit_bits), digits};
}

template <int digits>
void count_digits(std::span<const Key> keys, int low, Histogram* counts) {
  for (const Key key : keys) {
    for (int d = 0; d < digits; ++d) {
      ++counts[d][digit(key, low + d * digit_bits)];
    }
  }
}

void scatter(Pairs from, Pairs to, int low, Histogram& counts) {
  std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), std::uint32_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::uint32_t place = counts[digit(from.keys[i], low)]++;
    to.keys[place] = from.keys[i];
    to.index[place] = from.index[i];
  }
}

void copy(Pairs from, Pairs to) {
  std::copy(from.keys.begin(), from.keys.end(), to.keys.begin());
  std::copy(from.index.begin(), from.index.end(), to.index.begin());
}

// Sorts by a window of bits, into `to`; `from` is overwritten.
template <int digits>
void sort_window(Pairs from, Pairs to, int low) {
  std::array<Histogram, digits> counts{};
  count_digits<digits>(from.keys, low, counts.data());
  bool done = false;  // is the latest order in `to`?
  for (int d = 0; d < digits; ++d) {
    const int bit = low + d * digit_bits;
    if (counts[d][digit(from.keys[0], bit)] != from.size()) {
      scatter(done ? to : from, done ? from : to, bit, counts[d]);
      done = !done;
    }
  }
  if (!done) copy(from, to);
}

void insert_in_order(Pairs pairs) {
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    const Key key = pairs.keys[i];
    const std::uint32_t index = pairs.index[i];
    std::size_t j = i;
    for (; j > 0 && pairs.keys[j - 1] > key; --j) {
      pairs.keys[j] = pairs.keys[j - 1];
      pairs.index[j] = pairs.index[j - 1];
    }
    pairs.keys[j] = key;
    pairs.index[j] = index;
  }
}

void sort_window(Pairs from, Pairs to, Window window) {
  switch (window.digits) {
    case 1:
      return sort_window<1>(from, to, window.low);
    case 2:
      return sort_window<2>(from, to, window.low);
    case 3:
      return sort_window<3>(from, to, window.low);
    default:
      return sort_window<most_digits>(from, to, window.low);
  }
}

Key differing_bits(std::span<const Key> keys) {
  Key differing = 0;
  for (const Key key : keys) {
    differing |= key ^ keys[0];
  }
  return differing;
}

void sort(Pairs from, Pairs to);

// Sorts every run of pairs whose keys agree from bit `agreed` upwards by the bits below.
void sort_runs(Pairs pairs, Pairs spare, int agreed) {
  for (std::size_t first = 0, last = 0; first < pairs.size(); first = last) {
    const Key shared = pairs.keys[first] >> agreed;
    for (last = first + 1; last < pairs.size() && pairs.keys[last] >> agreed == shared;) {
      ++last;
    }
    if (last - first > short_run) {
      const Pairs run = pairs.part(first, last), room = spare.part(first, last);
      copy(run, room);
      sort(room, run);
    } else if (last - first > 1) {
      insert_in_order(pairs.part(first, last));
    }
  }
}

// Sorts into `to`; `from` is overwritten.
void sort(Pairs from, Pairs to) {
  const Key differing = differing_bits(from.keys);
  if (differing == 0 || from.size() <= short_run) {
    copy(from, to);
    if (differing != 0) insert_in_order(to);
    return;
  }
  const Window window = leading_window(differing, from.size());
  sort_window(from, to, window);
  if (std::countr_zero(differing) < window.low) {
    sort_runs(to, from, window.low);
  }
}

// Parts the pairs by their highest differing digit, for threads to sort what each bucket holds:
// that fits their caches, too. The pairs are parted in portions, one after the other, so that the
// order is kept; the result depends on neither.
void sort_by_buckets(Pairs pairs, Pairs spare, Key differing) {
  const int low = std::max(0, static_cast<int>(std::bit_width(differing)) - digit_bits);
  const std::size_t n = pairs.size();
  std::array<Histogram, portions> place{};
  const auto begin = [n](std::size_t p) { return n * p / portions; };
#pragma omp parallel for schedule(static)
  for (std::size_t p = 0; p < portions; ++p) {
    for (std::size_t i = begin(p); i < begin(p + 1); ++i) ++place[p][digit(pairs.keys[i], low)];
  }
  std::array<std::uint32_t, buckets + 1> first{};
  std::uint32_t next = 0;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    first[bucket] = next;
    for (Histogram& counts : place) next += std::exchange(counts[bucket], next);
  }
  first[buckets] = next;
#pragma omp parallel for schedule(static)
  for (std::size_t p = 0; p < portions; ++p) {
    for (std::size_t i = begin(p); i < begin(p + 1); ++i) {
      const std::uint32_t to = place[p][digit(pairs.keys[i], low)]++;
      spare.keys[to] = pairs.keys[i];
      spare.index[to] = pairs.index[i];
    }
  }
#pragma omp parallel for schedule(dynamic)
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    if (first[bucket] == first[bucket + 1]) continue;
    sort(spare.part(first[bucket], first[bucket + 1]),
         pairs.part(first[bucket], first[bucket + 1]));
  }
}

}  // namespace

void radix_sort(std::vector<Key>& keys, std::vector<std::uint32_t>& index) {
  if (index.size() != keys.size()) {
    throw std::invalid_argument("radix_sort: " + std::to_string(keys.size()) + " keys but " +
                                std::to_string(index.size()) + " indices");
  }
  const Pairs pairs{keys, index};
  if (keys.size() <= short_run) {
    insert_in_order(pairs);
    return;
  }
  const Key differing = differing_bits(keys);
  if (differing == 0) {
    return;
  }
  const std::size_t n = keys.size();
  const auto spare_keys = std::make_unique_for_overwrite<Key[]>(n);
  const auto spare_index = std::make_unique_for_overwrite<std::uint32_t[]>(n);
  const Pairs spare{{spare_keys.get(), n}, {spare_index.get(), n}};
  if (n > long_run) {
    sort_by_buckets(pairs, spare, differing);
  } else {
    copy(pairs, spare);
    sort(spare, pairs);
  }
}

}  // namespace vortree::tree
