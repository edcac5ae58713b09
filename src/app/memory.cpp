#include "app/memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

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

double machine_bytes() {
  double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGE_SIZE);
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
  for (const char* file :
       {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
    if (double most = 0; std::ifstream(file) >> most) bytes = std::min(bytes, most);
  return bytes;
}

}  // namespace vortree::app
