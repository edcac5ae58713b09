#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tree/order/morton.hpp"

namespace vortree::tree {

/// A code on its way, and what it belongs to.
struct Record {
  MortonKey key;
  std::uint32_t index;
};

/// Sorts runs that fit the cache; one for each thread.
///
/// The bits in which keys of the run differ and the place in it make one 64-bit number, so that
/// plain numbers are sorted and equal keys keep their order: one counting pass by as many leading
/// bits as there are places, insertion for what still shares those, and again for crowds of them.
///
/// cost    O(n) for keys that are spread, O(n) for each 16 leading bits that a crowd shares
class RunSort {
 public:
  /// The most bits that keys of a run of n may differ in, for all of them to count.
  [[nodiscard]] static int most_bits(std::size_t n);

  /// Writes a run in order of its keys. From the highest bit that differs down to the lowest,
  /// most_bits of them count: keys that differ in lower ones alone keep their order.
  ///
  /// differing    no two keys of the run differ in other bits
  /// keys, index  as long as the run
  void operator()(std::span<const Record> run, MortonKey differing, std::span<MortonKey> keys,
                  std::span<std::uint32_t> index);

  /// Sorts keys by all of their bits, in place, carrying an index along.
  ///
  /// keys   at most `most_whole`
  void whole(std::span<MortonKey> keys, std::span<std::uint32_t> index);
  static constexpr std::size_t most_whole = 512;

 private:
  void sort(std::span<std::uint64_t> numbers, std::span<std::uint64_t> spare);

  std::vector<Record> records_;
  std::vector<std::uint64_t> numbers_, spare_;
  std::vector<std::uint32_t> place_;
};

}  // namespace vortree::tree
