#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace vortree::bench {

/// What the system says of this process under a name ("VmHWM:", "VmRSS:") [bytes]; nothing if it
/// does not tell.
[[nodiscard]] std::optional<std::size_t> status_bytes(std::string_view name);

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
