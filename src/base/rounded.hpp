#pragma once

#include <array>
#include <charconv>
#include <cmath>
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

/// The same, but never above the value: what "or less" is said of. And never below it.
[[nodiscard]] inline std::string rounded_down(double value, int digits) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - digits + 1);
  // A value that has no more digits keeps them, whatever binary makes of it.
  return rounded(std::floor(value / unit * (1 + 1e-14)) * unit, digits);
}
[[nodiscard]] inline std::string rounded_up(double value, int digits) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - digits + 1);
  return rounded(std::ceil(value / unit * (1 - 1e-14)) * unit, digits);
}

}  // namespace vortree
