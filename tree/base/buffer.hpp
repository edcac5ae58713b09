#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "tree/base/memory.hpp"

namespace vortree::tree {

/// An array that is filled anew again and again: unlike a vector it does not write zeros first, and
/// unlike a fresh one it finds its pages where they were, large ones if there are. First touch of
/// fresh memory costs more than a neighbor search.
template <class T>
class Buffer {
 public:
  /// Room for n values; the values themselves are lost.
  void renew(std::size_t n) {
    if (n > values_.capacity()) {
      const std::size_t eighth_more = values_.capacity() + values_.capacity() / 8;
      values_ = {};  // before there is more
      values_.reserve(std::max(n, eighth_more));
    }
    values_.resize(n);
  }

  /// Room for n values at least; the values themselves are lost if there was less.
  void widen(std::size_t n) {
    if (n > values_.size()) renew(n);
  }

  [[nodiscard]] T* data() { return values_.data(); }
  [[nodiscard]] const T* data() const { return values_.data(); }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] std::size_t bytes() const { return values_.capacity() * sizeof(T); }
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  [[nodiscard]] std::span<T> span() { return values_; }
  [[nodiscard]] std::span<const T> span() const { return values_; }

 private:
  Unwritten<T> values_;
};

}  // namespace vortree::tree
