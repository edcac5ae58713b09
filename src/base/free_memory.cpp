#include "base/free_memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "base/memory.hpp"

namespace vortree {
namespace {

constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();

std::uint64_t left_of_machine() {
  return listed_bytes("/proc/meminfo", "MemAvailable:").value_or(unknown);
}

std::uint64_t number_in(const char* file) {
  std::uint64_t number = 0;
  return std::ifstream(file) >> number ? number : unknown;
}

/// Of the control group that a container sees as its root.
std::uint64_t limit_of_group() {
  return number_in("/sys/fs/cgroup/memory.max");
}

std::uint64_t left_of_group() {
  const std::uint64_t most = limit_of_group(), taken = number_in("/sys/fs/cgroup/memory.current");
  if (most == unknown || taken == unknown) return unknown;
  return most - std::min(most, taken);
}

std::uint64_t limit_of_addresses() {
  rlimit limit{};
  const bool limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return limited ? limit.rlim_cur : unknown;
}

std::uint64_t left_of_addresses() {
  const std::uint64_t most = limit_of_addresses();
  if (most == unknown) return unknown;
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const std::uint64_t taken = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return most - std::min(most, taken);
}

}  // namespace

std::uint64_t free_memory() {
  return std::min({left_of_machine(), left_of_group(), left_of_addresses()});
}

std::uint64_t machine_memory() {
  const std::uint64_t all = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                            static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  const std::uint64_t older_group = number_in("/sys/fs/cgroup/memory/memory.limit_in_bytes");
  return std::min({all, limit_of_group(), older_group, limit_of_addresses()});
}

}  // namespace vortree
