#include "app/memory.hpp"

#include <sys/resource.h>

#include <fstream>
#include <string>

namespace vortree::app {

// getrusage alone would report the parent's memory as well: a process that a large one starts by
// fork and exec inherits its ru_maxrss.
std::size_t peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (std::size_t kibibytes = 0; word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace vortree::app
