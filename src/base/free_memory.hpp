#pragma once

#include <cstdint>

namespace vortree {

/// Bytes of memory that this process may still take: what the machine has left without swapping,
/// within the limit of the control group and that of the address space, as far as they are known.
[[nodiscard]] std::uint64_t free_memory();

/// What it may have in all: the memory of the machine, or less by one of those limits.
[[nodiscard]] std::uint64_t machine_memory();

}  // namespace vortree
