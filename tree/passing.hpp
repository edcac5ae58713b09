#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace vortree::tree {

template <class T>
struct PassingAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = PassingAllocator<U>;
  };
  template <class U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
};

/// A vector that is soon gone, and whose resize() leaves new elements unwritten. Unlike Unwritten it
/// is not kept for its like: whatever is asked for next, of any size, may have its memory.
template <class T>
using Passing = std::vector<T, PassingAllocator<T>>;

}  // namespace vortree::tree
