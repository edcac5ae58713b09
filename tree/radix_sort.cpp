#include "tree/radix_sort.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace vortree::tree {

namespace {

constexpr int digit_bits = 8;
constexpr int digits = 4;
constexpr int window_bits = digits * digit_bits;
constexpr std::size_t buckets = std::size_t{1} << digit_bits;
using Histogram = std::array<std::uint32_t, buckets>;

// Below this length, insertion is faster than counting.
constexpr std::size_t short_run = 32;

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

std::array<Histogram, digits> count_digits(std::span<const Key> keys, int low) {
  std::array<Histogram, digits> counts{};
  for (const Key key : keys) {
    for (int d = 0; d < digits; ++d) {
      ++counts[d][digit(key, low + d * digit_bits)];
    }
  }
  return counts;
}

void scatter(Pairs from, Pairs to, int low, Histogram& counts) {
  std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), std::uint32_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::uint32_t place = counts[digit(from.keys[i], low)]++;
    to.keys[place] = from.keys[i];
    to.index[place] = from.index[i];
  }
}

// Sorts by the window of bits that begins at `low`; `spare` is as long as `pairs`.
void sort_window(Pairs pairs, Pairs spare, int low) {
  std::array<Histogram, digits> counts = count_digits(pairs.keys, low);
  Pairs from = pairs, to = spare;
  for (int d = 0; d < digits; ++d) {
    const int bit = low + d * digit_bits;
    if (counts[d][digit(from.keys[0], bit)] != from.size()) {
      scatter(from, to, bit, counts[d]);
      std::swap(from, to);
    }
  }
  if (from.keys.data() != pairs.keys.data()) {
    std::copy(from.keys.begin(), from.keys.end(), pairs.keys.begin());
    std::copy(from.index.begin(), from.index.end(), pairs.index.begin());
  }
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

// Sorts every run of pairs whose keys agree from bit `agreed` upwards by the bits below.
void sort_runs(Pairs pairs, Pairs spare, int agreed) {
  for (std::size_t first = 0, last = 0; first < pairs.size(); first = last) {
    const Key shared = pairs.keys[first] >> agreed;
    for (last = first + 1; last < pairs.size() && pairs.keys[last] >> agreed == shared;) {
      ++last;
    }
    if (last - first > short_run) {
      sort_window(pairs.part(first, last), spare.part(first, last), 0);
    } else if (last - first > 1) {
      insert_in_order(pairs.part(first, last));
    }
  }
}

}  // namespace

void radix_sort(std::vector<Key>& keys, std::vector<std::uint32_t>& index) {
  if (index.size() != keys.size()) {
    throw std::invalid_argument("radix_sort: " + std::to_string(keys.size()) + " keys but " +
                                std::to_string(index.size()) + " indices");
  }
  Key differing = 0;
  for (const Key key : keys) {
    differing |= key ^ keys[0];
  }
  if (differing == 0) {
    return;
  }
  if (keys.size() <= short_run) {
    insert_in_order({keys, index});
    return;
  }
  std::vector<Key> spare_keys(keys.size());
  std::vector<std::uint32_t> spare_index(keys.size());
  const Pairs pairs{keys, index}, spare{spare_keys, spare_index};
  const int low = std::max(0, static_cast<int>(std::bit_width(differing)) - window_bits);
  sort_window(pairs, spare, low);
  if (std::countr_zero(differing) < low) {
    sort_runs(pairs, spare, low);
  }
}

}  // namespace vortree::tree
