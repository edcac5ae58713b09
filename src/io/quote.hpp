#pragma once

#include <string>
#include <string_view>

namespace vortree::io {

/// The text between double quotes, with the escapes that TOML and JSON share.
[[nodiscard]] std::string quote(std::string_view text);

}  // namespace vortree::io
