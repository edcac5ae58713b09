#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace vortree::io {

/// A frames file keeps no longer one beside its frames.
inline constexpr std::size_t longest_scene = 60000;

/// What is wrong with a line of a text, before anyone looks for TOML in it.
struct BadLine {
  std::size_t line;
  std::string words;
};

/// Nothing if the text is UTF-8 without NUL, and no key in it has so many dots that a parser that
/// goes down a call for each runs out of stack.
[[nodiscard]] std::optional<BadLine> unfit_for_toml(std::string_view text);

}  // namespace vortree::io
