#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace vortree::io {

/// One character of a text, or one byte that belongs to none.
struct Character {
  std::size_t bytes = 1;
  char32_t code = 0;
  bool valid = false;
};

/// The first character of a text that is not empty. Surrogates, overlong forms and what lies beyond
/// U+10FFFF are not valid (The Unicode Standard, table 3-7).
[[nodiscard]] Character first_character(std::string_view text);

/// Where the first byte stands that is not UTF-8; nothing if there is none.
[[nodiscard]] std::optional<std::size_t> first_not_utf8(std::string_view text);

}  // namespace vortree::io
