#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <vector>

#include "bench/rivals/trees/tree_rivals.hpp"
#include "tree/base/parallel.hpp"
#include "tree/order/encode_kernel.hpp"
#include "tree/order/radix_sort.hpp"
#include "tree/order/run_sort.hpp"

namespace vortree::bench {
namespace {

using tree::MortonKey;
using tree::Range;
using tree::Record;
using tree::RunSort;

/// Codes one after the other in an order that was right for slightly different ones: for places
/// [first, first + keys.size()) of that order.
using CodesOf = std::function<void(std::size_t first, std::span<MortonKey> keys)>;

constexpr std::size_t block_size = 1024;

constexpr std::size_t most_leaving = 5;  // one in so many

bool before(const Record& a, const Record& b) {
  return a.key < b.key || (a.key == b.key && a.index < b.index);
}

// Puts records in order whose keys agree in all but the lowest bits and come one
// after the other.
void order_alike(std::span<MortonKey> keys, std::span<std::uint32_t> index, int low_bits) {
  std::vector<Record> alike;
  for (std::size_t first = 0, last = 0; first < keys.size(); first = last) {
    const MortonKey shared = keys[first] >> low_bits;
    for (last = first + 1; last < keys.size() && keys[last] >> low_bits == shared;) {
      ++last;
    }
    if (last - first == 1) continue;
    alike.clear();
    for (std::size_t i = first; i < last; ++i) alike.push_back({keys[i], index[i]});
    std::sort(alike.begin(), alike.end(), before);
    for (std::size_t i = first; i < last; ++i) {
      keys[i] = alike[i - first].key;
      index[i] = alike[i - first].index;
    }
  }
}

class Repair {
 public:
  Repair(std::span<const std::uint32_t> previous, const CodesOf& codes_of)
      : previous_(previous),
        codes_of_(codes_of),
        blocks_((previous.size() + block_size - 1) / block_size),
        staying_(blocks_, 0),
        records_(std::make_unique_for_overwrite<Record[]>(previous.size())) {
    find_bounds();
  }

  bool run(Unwritten<MortonKey>& keys, Unwritten<std::uint32_t>& index) {
    const std::size_t pieces = tree::pieces_of(previous_.size());
    leaving_.resize(pieces);
    tree::for_each_piece(pieces, [&](std::size_t p) {
      const Range some = tree::piece(blocks_, p, pieces);
      for (std::uint32_t b = some.first; b < some.last; ++b) part(b, leaving_[p]);
    });
    if (!gather_leaving()) return false;
    keys.resize(previous_.size());
    index.resize(previous_.size());
    tree::for_each_piece(pieces, [&](std::size_t p) {
      const Range some = tree::piece(blocks_, p, pieces);
      Bench bench;
      for (std::uint32_t b = some.first; b < some.last; ++b) join(b, bench, keys, index);
    });
    return true;
  }

 private:
  // What a thread needs to sort and merge.
  struct Bench {
    RunSort sort_run;
    std::vector<Record> records;
  };

  [[nodiscard]] Range places(std::size_t block) const {
    return {static_cast<std::uint32_t>(block * block_size),
            static_cast<std::uint32_t>(std::min(previous_.size(), (block + 1) * block_size))};
  }

  // A block begins at the middle one of some keys there: few strays do not matter.
  void find_bounds() {
    std::array<MortonKey, 7> some;
    bounds_.assign(blocks_ + 1, 0);
    for (std::size_t b = 1; b < blocks_; ++b) {
      const std::size_t first =
          std::min(b * block_size - some.size() / 2, previous_.size() - some.size());
      codes_of_(first, some);
      std::ranges::nth_element(some, some.begin() + some.size() / 2);
      bounds_[b] = std::max(bounds_[b - 1], some[some.size() / 2]);
    }
    bounds_[blocks_] = ~MortonKey{0};  // greater than any code
  }

  // Who stays in a block is kept at its beginning, in the order of before.
  void part(std::size_t block, std::vector<Record>& leaving) {
    const Range run = places(block);
    std::array<MortonKey, block_size> room;
    const std::span<MortonKey> keys(room.data(), run.size());
    codes_of_(run.first, keys);
    const MortonKey low = bounds_[block], high = bounds_[block + 1];
    Record* to = &records_[run.first];
    for (std::size_t i = 0; i < keys.size(); ++i) {
      *to = {keys[i], previous_[run.first + i]};
      if (keys[i] >= low && keys[i] < high) {
        ++to;
      } else {
        leaving.push_back(*to);
      }
    }
    staying_[block] = static_cast<std::uint32_t>(to - &records_[run.first]);
  }

  // Sorts who leaves, and finds which of them come to each block.
  bool gather_leaving() {
    std::vector<MortonKey> keys;
    std::vector<std::uint32_t> index;
    std::size_t n = 0;
    for (const auto& some : leaving_) n += some.size();
    if (n > previous_.size() / most_leaving) return false;
    for (const auto& some : leaving_) {
      for (const Record& record : some) keys.push_back(record.key), index.push_back(record.index);
    }
    tree::radix_sort(keys, index);
    coming_.resize(n);
    for (std::size_t i = 0; i < n; ++i) coming_[i] = {keys[i], index[i]};
    first_coming_.resize(blocks_ + 1);
    start_.resize(blocks_ + 1);
    std::size_t next = 0, start = 0;
    for (std::size_t b = 0; b < blocks_; ++b) {
      first_coming_[b] = next;
      start_[b] = start;
      start += staying_[b];
      for (; next < n && coming_[next].key < bounds_[b + 1]; ++next) ++start;
    }
    first_coming_[blocks_] = next;
    start_[blocks_] = start;
    return true;
  }

  void join(std::size_t block, Bench& bench, std::span<MortonKey> keys,
            std::span<std::uint32_t> index) const {
    const std::span<const Record> stayed(&records_[places(block).first], staying_[block]);
    const std::span<const Record> come(coming_.data() + first_coming_[block],
                                       first_coming_[block + 1] - first_coming_[block]);
    bench.records.assign(stayed.begin(), stayed.end());
    bench.records.insert(bench.records.end(), come.begin(), come.end());
    write(bench, keys.subspan(start_[block], bench.records.size()),
          index.subspan(start_[block], bench.records.size()));
  }

  static void write(Bench& bench, std::span<MortonKey> keys, std::span<std::uint32_t> index) {
    std::vector<Record>& records = bench.records;
    MortonKey least = ~MortonKey{0}, greatest = 0;
    bool ordered = true;
    for (std::size_t i = 0; i < records.size(); ++i) {
      least = std::min(least, records[i].key);
      ordered &= i == 0 || records[i].key > greatest;
      greatest = std::max(greatest, records[i].key);
    }
    if (ordered) {
      for (std::size_t i = 0; i < records.size(); ++i) {
        keys[i] = records[i].key;
        index[i] = records[i].index;
      }
      return;
    }
    // Above the least key, so that few leading bits are wasted.
    for (Record& record : records) record.key -= least;
    const int bits = static_cast<int>(std::bit_width(greatest - least));
    bench.sort_run(records, bits == 0 ? 0 : ~MortonKey{0} >> (64 - bits), keys, index);
    order_alike(keys, index, std::max(0, bits - RunSort::most_bits(records.size())));
    for (MortonKey& key : keys) key += least;
  }

  std::span<const std::uint32_t> previous_;
  const CodesOf& codes_of_;
  std::size_t blocks_;
  std::vector<MortonKey> bounds_;  // block b holds keys in [bounds[b], bounds[b + 1])
  std::vector<std::uint32_t> staying_;
  std::unique_ptr<Record[]> records_;
  std::vector<std::vector<Record>> leaving_;  // by piece
  std::vector<Record> coming_;                // all that leave, in order
  std::vector<std::size_t> first_coming_, start_;
};

// Of some points that are not next to each other.
void encode_some(tree::Points points, const tree::Domain& domain,
                 std::span<const std::uint32_t> index, std::size_t first,
                 std::span<MortonKey> keys) {
  constexpr std::size_t most = 256, ahead = 48;
  const tree::kernel::DomainAxis along_x{domain.x0, domain.x0 + domain.side, 0x1p31 / domain.side};
  const tree::kernel::DomainAxis along_y{domain.y0, domain.y0 + domain.side, 0x1p31 / domain.side};
  std::array<double, most> x, y;
  for (std::size_t done = 0; done < keys.size(); done += most) {
    const std::size_t n = std::min(most, keys.size() - done);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t place = first + done + i;
      const std::uint32_t next = index[std::min(place + ahead, index.size() - 1)];
      __builtin_prefetch(&points.x[next]);
      __builtin_prefetch(&points.y[next]);
      x[i] = points.x[index[place]], y[i] = points.y[index[place]];
    }
    (void)tree::kernel::codes(x.data(), y.data(), n, along_x, along_y, ~MortonKey{0}, &keys[done]);
  }
}

}  // namespace

tree::MortonOrder repaired_order(tree::Points points, const tree::Domain& domain,
                                 std::span<const std::uint32_t> previous) {
  tree::MortonOrder order{domain, tree::max_level, {}, {}};
  const CodesOf codes_of = [&](std::size_t first, std::span<MortonKey> keys) {
    encode_some(points, domain, previous, first, keys);
  };
  // so few are sorted at once
  const bool few = previous.size() < 4 * block_size;
  if (few || !Repair(previous, codes_of).run(order.keys, order.index)) {
    return tree::morton_order(points, domain);
  }
  return order;
}

}  // namespace vortree::bench
