#pragma once

#include <cstdint>

namespace vortree::io {

/// Bytes of memory that this process may still take: what the machine has left without swapping,
/// within the limit of the control group and that of the address space, as far as they are known.
[[nodiscard]] std::uint64_t free_memory();

}  // namespace vortree::io
