#include "app/memory.hpp"

#include <sys/resource.h>

#include "bench/memory.hpp"

namespace vortree::app {

// getrusage alone would report the parent's memory as well: a process that a large one starts by
// fork and exec inherits its ru_maxrss.
std::size_t peak_bytes() {
  if (const auto most = bench::status_bytes("VmHWM:")) return *most;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace vortree::app
