#include "tree/base/memory.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <mutex>
#include <new>

#ifdef __linux__
#include <sys/mman.h>

#include "tree/base/tuning.hpp"
#endif

namespace vortree::kept_memory {
namespace {

constexpr std::size_t large_page = 2u << 20;
constexpr std::align_val_t alignment{large_page};

// Sizes are rounded up, by an eighth at most, so that a little more or less next time fits.
std::size_t rounded(std::size_t bytes) {
  std::size_t unit = std::size_t{1} << 10;
  while (unit * 16 <= bytes) unit *= 2;
  return (bytes + unit - 1) / unit * unit;
}

// Memory of the system comes in regions. They are cut where less is asked for, and what comes back
// grows together again with what is idle beside it: so one large block serves several small ones
// after another.
class Store {
 public:
  void* take(std::size_t bytes) {
    const std::size_t size = rounded(bytes);
    const std::lock_guard lock(mutex_);
    auto piece = best_fit(size);
    if (piece == idle_.end()) piece = add_region(std::max(size, large_page));
    std::byte* const memory = piece->first;
    if (piece->second > size) idle_.emplace(memory + size, piece->second - size);
    idle_.erase(piece);
    idle_bytes_ -= size;
    used_.emplace(memory, size);
    used_bytes_ += size;
    most_ = std::max(most_, used_bytes_);
    shrink(most_ + most_ / tree::spare_memory + 2 * large_page - used_bytes_);
    return memory;
  }

  void give_back(void* memory) {
    const std::lock_guard lock(mutex_);
    const auto used = used_.find(static_cast<std::byte*>(memory));
    const std::size_t size = used->second;
    used_bytes_ -= size;
    idle_bytes_ += size;
    const auto piece = idle_.emplace(used->first, size).first;
    used_.erase(used);
    join(piece, std::next(piece));
    if (piece != idle_.begin()) join(std::prev(piece), piece);
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
  using Pieces = std::map<std::byte*, std::size_t>;  // by address, with their bytes

  Pieces::iterator best_fit(std::size_t size) {
    auto best = idle_.end();
    for (auto piece = idle_.begin(); piece != idle_.end(); ++piece) {
      if (piece->second < size) continue;
      if (best == idle_.end() || piece->second < best->second) best = piece;
    }
    return best;
  }

  Pieces::iterator add_region(std::size_t size) {
    void* memory = ::operator new(size, alignment, std::nothrow);
    if (memory == nullptr) {
      shrink(0);
      memory = ::operator new(size, alignment);
    }
#ifdef __linux__
    madvise(memory, size, MADV_HUGEPAGE);  // a wish: if refused, nothing is lost
#endif
    const auto region = regions_.emplace(static_cast<std::byte*>(memory), size).first;
    idle_bytes_ += size;
    return idle_.insert(*region).first;
  }

  // Makes one piece of two neighbors of a region.
  void join(Pieces::iterator first, Pieces::iterator second) {
    if (second == idle_.end() || first->first + first->second != second->first) return;
    if (regions_.contains(second->first)) return;
    first->second += second->second;
    idle_.erase(second);
  }

  // Frees idle regions until no more than so many bytes are left, or no region is idle throughout.
  // The smallest that is enough goes, else the largest: what goes will soon be missed.
  void shrink(std::size_t bytes) {
    while (idle_bytes_ > bytes) {
      const std::size_t excess = idle_bytes_ - bytes;
      auto best = regions_.end();
      for (auto region = regions_.begin(); region != regions_.end(); ++region) {
        const auto piece = idle_.find(region->first);
        if (piece == idle_.end() || piece->second != region->second) continue;
        const auto better = [&](std::size_t a, std::size_t b) {
          return a >= excess && b >= excess ? a < b : a > b;
        };
        if (best == regions_.end() || better(region->second, best->second)) best = region;
      }
      if (best == regions_.end()) return;
      idle_bytes_ -= best->second;
      idle_.erase(best->first);
      ::operator delete(best->first, alignment);
      regions_.erase(best);
    }
  }

  std::mutex mutex_;
  Pieces regions_, idle_, used_;
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
