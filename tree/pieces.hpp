#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>

#include "tree/points.hpp"

namespace vortree::tree {

/// Work on more things than this is shared among threads, in so many pieces. Threads that slept are
/// some 50 microseconds late, and a tree takes ten turns of them: fewer points are done by then.
inline constexpr std::size_t worth_sharing = 150000, shared_pieces = 16;

[[nodiscard]] inline std::size_t pieces_of(std::size_t n) {
  return n > worth_sharing ? shared_pieces : 1;
}

/// The p-th of some pieces of n things.
[[nodiscard]] inline Range piece(std::size_t n, std::size_t p, std::size_t pieces) {
  return {static_cast<std::uint32_t>(n * p / pieces),
          static_cast<std::uint32_t>(n * (p + 1) / pieces)};
}

/// Calls work(p) for every piece, threads side by side. What the work throws comes out.
template <class Work>
void for_each_piece(std::size_t pieces, const Work& work) {
  if (pieces == 1) return work(std::size_t{0});
  std::exception_ptr thrown;
#pragma omp parallel for schedule(dynamic)
  for (std::size_t p = 0; p < pieces; ++p) {
    try {
      work(p);
    } catch (...) {
#pragma omp critical(vortree_tree_pieces)
      thrown = std::current_exception();
    }
  }
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace vortree::tree
