#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/arrays/array_file.hpp"

namespace vortree::io {

/// So many bytes from a place on. throws BadArray if the file ends before.
[[nodiscard]] inline std::string_view piece(std::string_view bytes, std::uint64_t at,
                                            std::uint64_t length) {
  if (at > bytes.size() || length > bytes.size() - at)
    throw BadArray("it is cut short: " + std::to_string(length) + " bytes were expected at byte " +
                   std::to_string(at) + ", it has " + std::to_string(bytes.size()));
  return bytes.substr(at, length);
}

/// The number that they spell, the lowest byte first; `width` is 8 at most.
[[nodiscard]] inline std::uint64_t little_endian(std::string_view bytes, std::uint64_t at,
                                                 unsigned width) {
  const std::string_view digits = piece(bytes, at, width);
  std::uint64_t value = 0;
  for (unsigned k = width; k-- > 0;) value = value << 8 | static_cast<unsigned char>(digits[k]);
  return value;
}

/// The same written behind a text.
inline void add_little_endian(std::string& text, std::uint64_t value, unsigned width) {
  for (unsigned k = 0; k < width; ++k) text += static_cast<char>(value >> (8 * k) & 0xff);
}

}  // namespace vortree::io
