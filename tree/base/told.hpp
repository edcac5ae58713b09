#pragma once

#include <array>
#include <charconv>
#include <string>

namespace vortree::tree {

/// A number as errors tell it: the shortest digits that read back to the same double.
[[nodiscard]] inline std::string told(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

}  // namespace vortree::tree
