#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace vortree {

/// What the system says of this process under a name ("VmHWM:", "VmRSS:") [bytes]; nothing if it
/// does not tell.
[[nodiscard]] std::optional<std::size_t> status_bytes(std::string_view name);

/// The most memory that this process has held at any time so far (resident set) [bytes].
std::size_t peak_bytes();

}  // namespace vortree
