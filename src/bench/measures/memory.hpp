#pragma once

#include <cstddef>
#include <optional>

namespace vortree::bench {

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
