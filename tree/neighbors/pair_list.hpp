#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

#include "tree/base/buffer.hpp"

namespace vortree::tree {

/// both_ways   j stands in the row of i and i in the row of j
/// once        each pair stands in one of the two rows: in that of the particle in the coarser
///             cell or, in cells of one level, of the one that is searched first
enum class Listing { both_ways, once };

/// Neighbors of n particles, in compressed rows: those of particle i are
///
///   index[start[i]], ..., index[start[i + 1] - 1],
///
/// in no order that matters, but always in the same. Particles are numbered as in the input; none
/// is its own neighbor.
///
/// start   n + 1 numbers: pairs beyond 2^32 fit
/// most    pairs that may be listed: a search that finds more throws std::length_error with both
///         numbers, before it asks for memory for them
struct PairList {
  Buffer<std::int64_t> start;
  Buffer<std::int32_t> index;
  std::int64_t most = std::numeric_limits<std::int64_t>::max();

  /// Makes room for so many pairs.
  ///
  /// throws  std::length_error if there are more than `most`
  void make_room(std::int64_t pairs) {
    if (pairs > most) refuse(pairs);
    index.renew(static_cast<std::size_t>(pairs));
  }
  [[noreturn]] void refuse(std::int64_t pairs) const {
    throw std::length_error("neighbors: " + std::to_string(pairs) + " pairs and more; at most " +
                            std::to_string(most) + " may be listed");
  }

  [[nodiscard]] std::size_t size() const { return start.size() == 0 ? 0 : start.size() - 1; }
  [[nodiscard]] std::span<const std::int32_t> row(std::size_t i) const {
    return index.span().subspan(static_cast<std::size_t>(start[i]),
                                static_cast<std::size_t>(start[i + 1] - start[i]));
  }
};

/// Shown particle i and its neighbors, which are gone when it returns. Called from several threads
/// at once, for different i.
using RowVisitor = std::function<void(std::int32_t i, std::span<const std::int32_t> neighbors)>;

}  // namespace vortree::tree
