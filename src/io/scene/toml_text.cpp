#include "io/scene/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/utf8.hpp"

namespace vortree::io {
namespace {

constexpr int most_dots = 500;

std::size_t line_of(std::string_view text, std::size_t at) {
  return 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + at, '\n'));
}

bool is_utf16(std::string_view text) {
  return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") ||
         text.substr(0, 2).find('\0') != std::string_view::npos;
}

std::optional<std::size_t> first_bad_byte(std::string_view text) {
  const std::size_t end = text.find('\0');
  const auto broken = first_not_utf8(text.substr(0, end));
  if (broken || end == std::string_view::npos) return broken;
  return end;
}

/// The first place where a line has had too many dots since its last comma: numbers of an array
/// stand between commas, parts of a key do not.
std::optional<std::size_t> first_deep_key(std::string_view text) {
  int dots = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\n' || text[at] == ',') dots = 0;
    if (text[at] == '.' && ++dots > most_dots) return at;
  }
  return std::nullopt;
}

}  // namespace

std::optional<BadLine> unfit_for_toml(std::string_view text) {
  if (const auto at = first_bad_byte(text)) {
    const auto byte = static_cast<unsigned char>(text[*at]);
    return BadLine{line_of(text, *at),
                   is_utf16(text) ? "the text is UTF-16; UTF-8 was expected"
                                  : fmt::format("the byte 0x{:02x} does not belong into a text of "
                                                "UTF-8",
                                                byte)};
  }
  if (const auto at = first_deep_key(text)) {
    return BadLine{line_of(text, *at), fmt::format("a key of more than {} parts", most_dots)};
  }
  return std::nullopt;
}

}  // namespace vortree::io
