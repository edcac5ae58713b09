#pragma once

#include <cstdlib>
#include <string_view>

namespace vortree::tree {

/// Whether OpenMP's threads sleep while they wait for the next loop: then they are some 50
/// microseconds late for it (on a virtual machine; woken by the system), else 2. As the environment
/// had it when the program began: OMP_WAIT_POLICY=passive, or GOMP_SPINCOUNT=0.
[[nodiscard]] inline bool threads_sleep() {
  const auto is = [](const char* name, std::string_view value) {
    const char* own = std::getenv(name);
    return own && value == own;
  };
  if (std::getenv("GOMP_SPINCOUNT")) return is("GOMP_SPINCOUNT", "0");
  return is("OMP_WAIT_POLICY", "passive") || is("OMP_WAIT_POLICY", "PASSIVE");
}

}  // namespace vortree::tree
