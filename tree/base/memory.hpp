#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace vortree {

/// Blocks of memory that outlive their vectors: the next step of a flow asks for the same
/// ones again, and fresh pages of the system cost more than most passes over them do (0.4 ns a
/// byte, with large pages 0.05), and malloc may return them at the end of every step. Blocks lie in
/// large pages, if the system has them, and serve again whole, in parts, or joined to what was cut
/// from them.
///
/// Kept are, together with what is in use, no more bytes than were once in use at the same time, an
/// eighth, and two large pages; unless a block in use holds on to the rest of its region. Safe for
/// threads.
namespace kept_memory {

/// Smaller blocks [bytes] are malloc's business: so few that it keeps them.
inline constexpr std::size_t least = 1u << 14;

/// bytes   at least `least`
/// throws  std::bad_alloc
[[nodiscard]] void* take(std::size_t bytes);
void give_back(void* memory) noexcept;

/// Returns to the system all that is not in use.
void release();
/// Bytes kept and not in use.
[[nodiscard]] std::size_t idle();

}  // namespace kept_memory

/// Memory for numbers that will all be written before they are read: not zeroed first, and kept
/// where it is large.
template <class T>
struct Untouched {
  using value_type = T;

  Untouched() = default;
  template <class U>
  explicit Untouched(const Untouched<U>&) {}

  [[nodiscard]] T* allocate(std::size_t n) {
    const std::size_t bytes = n * sizeof(T);
    if (bytes >= kept_memory::least) return static_cast<T*>(kept_memory::take(bytes));
    return static_cast<T*>(::operator new(bytes, alignment));
  }

  void deallocate(T* memory, std::size_t n) {
    if (n * sizeof(T) >= kept_memory::least) return kept_memory::give_back(memory);
    ::operator delete(memory, alignment);
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

 private:
  static constexpr std::align_val_t alignment{64};
};

/// A vector whose resize() leaves new elements unwritten.
template <class T>
using Unwritten = std::vector<T, Untouched<T>>;

using Reals = Unwritten<double>;

}  // namespace vortree
