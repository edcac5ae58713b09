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

// OpenMP ends each of its regions, even that of one thread, with a call of the system, half a
// microsecond: what is not shared is none.

/// Calls work(p) for every piece, threads side by side. What the work throws comes out.
template <class Work>
void for_each_piece(std::size_t pieces, const Work& work) {
  if (pieces == 1) return work(std::size_t{0});
  Thrown thrown;
#pragma omp parallel for schedule(dynamic)
  for (std::size_t p = 0; p < pieces; ++p) thrown.guard([&] { work(p); });
  thrown.rethrow();
}

/// Calls work(i) for each of some things in a row. shared: each thread has an even part of them,
/// and the work throws nothing.
template <class Work>
void share_evenly(Range things, bool shared, const Work& work) {
  if (!shared) {
    for (std::uint32_t i = things.first; i < things.last; ++i) work(i);
    return;
  }
#pragma omp parallel for schedule(static)
  for (std::uint32_t i = things.first; i < things.last; ++i) work(i);
}

/// Calls work(i, own) for each of some things, with what make() gives its thread. shared: threads
/// take so many in turn, and the work throws nothing.
template <class Make, class Work>
void share_in_turn(Range things, int turn, bool shared, const Make& make, const Work& work) {
  if (!shared) {
    auto own = make();
    for (std::uint32_t i = things.first; i < things.last; ++i) work(i, own);
    return;
  }
#pragma omp parallel
  {
    auto own = make();
#pragma omp for schedule(dynamic, turn)
    for (std::uint32_t i = things.first; i < things.last; ++i) work(i, own);
  }
}

/// The same where threads need nothing of their own.
template <class Work>
void share_in_turn(Range things, int turn, bool shared, const Work& work) {
  share_in_turn(
      things, turn, shared, [] { return 0; }, [&](std::uint32_t i, int) { work(i); });
}

/// n things.
[[nodiscard]] inline Range all_of(std::size_t n) {
  return {0, static_cast<std::uint32_t>(n)};
}

}  // namespace vortree::tree
