#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>

#include "tree/base/range.hpp"
#include "tree/base/tuning.hpp"

namespace vortree::tree {

/// Pieces of work on n points.
[[nodiscard]] inline std::size_t pieces_of(std::size_t n) {
  return n > worth_sharing ? shared_pieces : 1;
}

/// The p-th of some pieces of n things.
[[nodiscard]] inline Range piece(std::size_t n, std::size_t p, std::size_t pieces) {
  return {static_cast<std::uint32_t>(n * p / pieces),
          static_cast<std::uint32_t>(n * (p + 1) / pieces)};
}

/// What is thrown by one of several threads, to be thrown again when they have joined: nothing may
/// leave a parallel region.
class Thrown {
 public:
  /// Does some work, unless something was thrown already.
  template <class Work>
  void guard(const Work& work) noexcept {
    if (is_thrown_.load(std::memory_order_relaxed)) return;
    try {
      work();
    } catch (...) {
#pragma omp critical(vortree_tree_thrown)
      if (!is_thrown_.exchange(true)) what_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (what_) std::rethrow_exception(what_);
  }

 private:
  std::atomic<bool> is_thrown_ = false;
  std::exception_ptr what_;
};

/// Calls work(p) for every piece, threads side by side. What the work throws comes out.
template <class Work>
void for_each_piece(std::size_t pieces, const Work& work) {
  if (pieces == 1) return work(std::size_t{0});
  Thrown thrown;
#pragma omp parallel for schedule(dynamic)
  for (std::size_t p = 0; p < pieces; ++p) thrown.guard([&] { work(p); });
  thrown.rethrow();
}

}  // namespace vortree::tree
