#include "tree/memory.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace vortree::kept_memory {
namespace {

constexpr std::align_val_t alignment{2u << 20};  // a large page

// A kept block is less than so many times as large as what it serves.
constexpr std::size_t too_large = 2;

// Sizes are rounded up, by an eighth at most, so that a little more or less next time fits.
std::size_t rounded(std::size_t bytes) {
  std::size_t unit = std::size_t{1} << 16;
  while (unit * 16 <= bytes) unit *= 2;
  return (bytes + unit - 1) / unit * unit;
}

class Store {
 public:
  void* take(std::size_t bytes) {
    std::size_t size = rounded(bytes);
    const std::lock_guard lock(mutex_);
    void* memory = nullptr;
    if (const auto fit = idle_.lower_bound(size);
        fit != idle_.end() && fit->first / size < too_large) {
      size = fit->first;
      memory = fit->second;
      idle_bytes_ -= size;
      idle_.erase(fit);
    } else {
      memory = fresh(size);
    }
    used_.emplace(memory, size);
    used_bytes_ += size;
    most_ = std::max(most_, used_bytes_);
    shrink(most_ + most_ / 2 - used_bytes_);
    return memory;
  }

  void give_back(void* memory) {
    const std::lock_guard lock(mutex_);
    const auto place = used_.find(memory);
    const std::size_t size = place->second;
    used_.erase(place);
    used_bytes_ -= size;
    idle_.emplace(size, memory);
    idle_bytes_ += size;
  }

  void release() {
    const std::lock_guard lock(mutex_);
    shrink(0);
    most_ = used_bytes_;
  }

  std::size_t idle() {
    const std::lock_guard lock(mutex_);
    return idle_bytes_;
  }

 private:
  void* fresh(std::size_t size) {
    void* memory = ::operator new(size, alignment, std::nothrow);
    if (memory == nullptr) {
      shrink(0);
      memory = ::operator new(size, alignment);
    }
#ifdef __linux__
    madvise(memory, size, MADV_HUGEPAGE);  // a wish: if refused, nothing is lost
#endif
    return memory;
  }

  // Frees idle blocks, the smallest first, until no more than so many bytes are left.
  void shrink(std::size_t bytes) {
    while (idle_bytes_ > bytes) {
      const auto smallest = idle_.begin();
      idle_bytes_ -= smallest->first;
      ::operator delete(smallest->second, alignment);
      idle_.erase(smallest);
    }
  }

  std::mutex mutex_;
  std::multimap<std::size_t, void*> idle_;
  std::map<void*, std::size_t> used_;
  std::size_t idle_bytes_ = 0, used_bytes_ = 0, most_ = 0;
};

// Never destroyed: vectors of static lifetime may come back after any destructor.
Store& store() {
  static Store& only = *new Store;
  return only;
}

}  // namespace

void* take(std::size_t bytes) {
  return store().take(bytes);
}

void give_back(void* memory) noexcept {
  store().give_back(memory);
}

void release() {
  store().release();
}

std::size_t idle() {
  return store().idle();
}

}  // namespace vortree::kept_memory
