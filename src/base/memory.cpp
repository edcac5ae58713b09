#include "base/memory.hpp"

#include <sys/resource.h>

#include <fstream>
#include <string>

namespace vortree {

std::optional<std::size_t> listed_bytes(const char* list, std::string_view name) {
  std::ifstream in(list);
  for (std::string word; in >> word;)
    if (std::size_t kibibytes = 0; word == name && in >> kibibytes) return kibibytes * 1024;
  return {};
}

std::optional<std::size_t> status_bytes(std::string_view name) {
  return listed_bytes("/proc/self/status", name);
}

// getrusage alone would report the parent's memory as well: a process that a large one starts by
// fork and exec inherits its ru_maxrss.
std::size_t peak_bytes() {
  if (const auto most = status_bytes("VmHWM:")) return *most;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace vortree
