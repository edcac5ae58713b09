#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>

namespace vortree::tree {

/// An array that is filled anew again and again: unlike a vector it does not write zeros first, and
/// unlike a fresh one it finds its pages where they were. First touch of fresh memory costs more
/// than a neighbor search.
template <class T>
class Buffer {
 public:
  Buffer() = default;
  Buffer(const Buffer& other) { assign(other); }
  Buffer& operator=(const Buffer& other) {
    if (this != &other) assign(other);
    return *this;
  }
  Buffer(Buffer&&) noexcept = default;
  Buffer& operator=(Buffer&&) noexcept = default;

  /// Room for n values; the values themselves are lost.
  void renew(std::size_t n) {
    if (n > capacity_) {
      values_.reset();
      capacity_ = capacity_ == 0 ? n : std::max(n, capacity_ + capacity_ / 8);
      values_ = std::make_unique_for_overwrite<T[]>(capacity_);
    }
    size_ = n;
  }

  [[nodiscard]] T* data() { return values_.get(); }
  [[nodiscard]] const T* data() const { return values_.get(); }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t bytes() const { return capacity_ * sizeof(T); }
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  [[nodiscard]] std::span<T> span() { return {values_.get(), size_}; }
  [[nodiscard]] std::span<const T> span() const { return {values_.get(), size_}; }

 private:
  void assign(const Buffer& other) {
    renew(other.size_);
    std::copy_n(other.values_.get(), other.size_, values_.get());
  }

  std::unique_ptr<T[]> values_;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace vortree::tree
