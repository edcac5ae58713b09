#pragma once

#include <cstddef>
#include <optional>

namespace vortree::bench {

/// Lets the C library keep what is freed, so that repeated sums find their memory warm, as the
/// steps of a flow do. For the whole process.
void keep_freed_memory();

/// Counts how much the process' memory grows at most, from now on.
class MemoryGrowth {
 public:
  /// What was kept goes back to the system first.
  MemoryGrowth();
  /// Bytes so far, or nothing if the system does not tell.
  [[nodiscard]] std::optional<std::size_t> bytes() const;

 private:
  std::optional<std::size_t> before_;
};

}  // namespace vortree::bench
