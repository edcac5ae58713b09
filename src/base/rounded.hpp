#pragma once

#include <array>
#include <charconv>
#include <string>

namespace vortree {

/// A number rounded to so many digits, as sentences tell it.
[[nodiscard]] inline std::string rounded(double value, int digits) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::general, digits)
                       .ptr;
  return {text.data(), end};
}

}  // namespace vortree
