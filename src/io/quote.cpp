#include "io/quote.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "io/utf8.hpp"

namespace vortree::io {
namespace {

/// What moves the cursor, changes colors or turns the direction of what follows.
bool harms_a_terminal(char32_t c) {
  const bool control = c < 0x20 || (c >= 0x7f && c < 0xa0);
  const bool turns = c == 0x061c || (c >= 0x200b && c <= 0x200f) || (c >= 0x2028 && c <= 0x202e) ||
                     (c >= 0x2060 && c <= 0x206f) || c == 0xfeff;
  return control || turns;
}

bool continues_character(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

}  // namespace

std::string quote(std::string_view text) {
  std::string quoted = "\"";
  while (!text.empty()) {
    const Character character = first_character(text);
    if (character.code == '"' || character.code == '\\') {
      quoted += {'\\', text[0]};
    } else if (!character.valid) {
      quoted += "\\ufffd";
    } else if (harms_a_terminal(character.code)) {
      quoted += fmt::format("\\u{:04x}", static_cast<std::uint32_t>(character.code));
    } else {
      quoted += text.substr(0, character.bytes);
    }
    text.remove_prefix(character.bytes);
  }
  return quoted + '"';
}

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const Character character = first_character(text);
    const std::string_view bytes = text.substr(0, character.bytes);
    if (character.valid && !harms_a_terminal(character.code)) {
      shown += bytes;
    } else if (character.code == '\n' || character.code == '\t') {
      shown += ' ';
    } else {
      for (const char byte : bytes) {
        shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
      }
    }
    text.remove_prefix(bytes.size());
  }
  return shown;
}

std::string shortened(std::string_view text, std::size_t most) {
  constexpr std::string_view gap = " ... ";
  if (text.size() <= most) return std::string(text);
  std::size_t head = (most - gap.size()) / 2, tail = text.size() - (most - gap.size() - head);
  while (head > 0 && continues_character(text[head])) --head;
  while (tail < text.size() && continues_character(text[tail])) ++tail;
  return fmt::format("{}{}{}", text.substr(0, head), gap, text.substr(tail));
}

}  // namespace vortree::io
