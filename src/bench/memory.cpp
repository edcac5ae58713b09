#include "bench/memory.hpp"

#include <malloc.h>

#include <fstream>
#include <string>

#include "tree/memory.hpp"

namespace vortree::bench {

std::optional<std::size_t> status_bytes(std::string_view name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (std::size_t kibibytes = 0; word == name && status >> kibibytes) return kibibytes * 1024;
  return {};
}

MemoryGrowth::MemoryGrowth() {
  kept_memory::release();
  malloc_trim(0);
  // Sets the high-water mark back to what is in use.
  std::ofstream reset("/proc/self/clear_refs");
  reset << 5 << std::flush;
  if (reset) before_ = status_bytes("VmRSS:");
}

std::optional<std::size_t> MemoryGrowth::bytes() const {
  const auto now = status_bytes("VmHWM:");
  if (!before_ || !now) return {};
  return *now > *before_ ? *now - *before_ : 0;
}

}  // namespace vortree::bench
