#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace vortree::python {

/// The value of an enumeration that a word names; words stand in the order of its values.
///
/// throws  std::invalid_argument that lists the words, if it is none of them
template <class Kind, std::size_t count>
[[nodiscard]] Kind chosen(std::string_view key, std::string_view word,
                          const std::array<std::string_view, count>& words) {
  std::string all;
  for (std::size_t k = 0; k < count; ++k) {
    if (words[k] == word) return static_cast<Kind>(k);
    all.append(k == 0 ? "\"" : ", \"").append(words[k]).append("\"");
  }
  throw std::invalid_argument(std::string(key) + " is \"" + std::string(word) +
                              "\"; it must be one of " + all);
}

inline constexpr std::array<std::string_view, 2> builder_words{"reverse", "forward"};

}  // namespace vortree::python
