#pragma once

#include <span>
#include <string>
#include <string_view>

namespace vortree::io {

/// The candidate that a mistyped word most likely means (fewest insertions, deletions and
/// replacements); empty if none is near: more than two slips, or a third of the word.
[[nodiscard]] std::string_view nearest(std::string_view word,
                                       std::span<const std::string_view> candidates);

/// "a, b, c"
[[nodiscard]] std::string listed(std::span<const std::string_view> words);

/// The same, but of a list longer than a line only the words nearest to one: "a, b, c and 39 more".
[[nodiscard]] std::string listed(std::span<const std::string_view> words, std::string_view near);

}  // namespace vortree::io
