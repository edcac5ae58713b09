#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace vortree::io {

/// The text between double quotes, with the escapes that TOML and JSON share: also for what would
/// harm a terminal. A byte that is no UTF-8 becomes the sign for that, U+FFFD.
[[nodiscard]] std::string quote(std::string_view text);

/// The text as a terminal may see it, in one line: a control character, a mark that turns the
/// direction of writing and a byte that is no UTF-8 become \xNN, one for each byte; the end of a
/// line becomes a space.
[[nodiscard]] std::string printable(std::string_view text);

/// At most so many bytes (16 or more): of a longer text the beginning and the end, "..." between.
/// Characters of UTF-8 are not torn.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most);

}  // namespace vortree::io
