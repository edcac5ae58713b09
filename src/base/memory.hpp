#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace vortree {

/// What a list of the system, name and kilobytes a line, says under a name [bytes]; nothing if it
/// does not tell.
[[nodiscard]] std::optional<std::size_t> listed_bytes(const char* list, std::string_view name);

/// The same of this process ("VmHWM:", "VmRSS:").
[[nodiscard]] std::optional<std::size_t> status_bytes(std::string_view name);

/// The most memory that this process has held at any time so far (resident set) [bytes].
std::size_t peak_bytes();

}  // namespace vortree
