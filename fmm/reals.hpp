#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace vortree::fmm {

/// Memory for numbers that will all be written before they are read: not zeroed first, and large
/// arrays ask for large pages. Touching fresh memory page by page costs more than most passes over
/// it do (seven times more with small pages than with large ones).
template <class T>
struct Untouched {
  using value_type = T;
  static constexpr std::size_t large_page = 2u << 20;

  Untouched() = default;
  template <class U>
  explicit Untouched(const Untouched<U>&) {}

  [[nodiscard]] static std::size_t bytes(std::size_t n) {
    const std::size_t unit = n * sizeof(T) < 2 * large_page ? 64 : large_page;
    return (n * sizeof(T) + unit - 1) / unit * unit;
  }

  [[nodiscard]] T* allocate(std::size_t n) {
    const bool large = bytes(n) >= 2 * large_page;
    void* memory = std::aligned_alloc(large ? large_page : 64, bytes(n));
    if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
    if (large) madvise(memory, bytes(n), MADV_HUGEPAGE);  // a wish: if refused, nothing is lost
#endif
    return static_cast<T*>(memory);
  }

  void deallocate(T* memory, std::size_t) {
    std::free(memory);
  }

  template <class U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

  bool operator==(const Untouched&) const = default;
};

/// A vector of doubles; resize() leaves new elements unwritten.
using Reals = std::vector<double, Untouched<double>>;

}  // namespace vortree::fmm
