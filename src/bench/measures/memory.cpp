#include "bench/measures/memory.hpp"

#include <malloc.h>

#include <fstream>

#include "base/memory.hpp"
#include "tree/base/memory.hpp"

namespace vortree::bench {

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
