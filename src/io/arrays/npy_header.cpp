#include "io/arrays/npy_header.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "io/arrays/bytes.hpp"
#include "io/quote.hpp"

namespace vortree::io {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

/// What of Python's literals such a dictionary needs, read word by word.
class NpyDictionary {
 public:
  explicit NpyDictionary(std::string_view text) : rest_(text) {}

  bool takes(char mark) {
    skip_blanks();
    if (rest_.empty() || rest_.front() != mark) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void expect(char mark) {
    if (!takes(mark)) refuse(fmt::format("{} was expected", mark));
  }
  bool done() {
    skip_blanks();
    return rest_.empty();
  }

  std::string text() {
    skip_blanks();
    const char mark = rest_.empty() ? ' ' : rest_.front();
    const std::size_t end = mark == '\'' || mark == '"' ? rest_.find(mark, 1) : rest_.npos;
    if (end == rest_.npos) refuse("a text in quotes was expected");
    const std::string found(rest_.substr(1, end - 1));
    rest_.remove_prefix(end + 1);
    return found;
  }

  bool truth() {
    skip_blanks();
    for (const auto& [word, value] : {std::pair{"True", true}, std::pair{"False", false}}) {
      if (!rest_.starts_with(word)) continue;
      rest_.remove_prefix(std::string_view(word).size());
      return value;
    }
    refuse("True or False was expected");
  }

  std::uint64_t count() {
    skip_blanks();
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{}) refuse("a number of elements was expected");
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    if (rest_.starts_with('L')) rest_.remove_prefix(1);  // of Python 2
    return value;
  }

  std::vector<std::uint64_t> counts() {
    std::vector<std::uint64_t> all;
    expect('(');
    while (!takes(')')) {
      all.push_back(count());
      if (!takes(',')) {
        expect(')');
        break;
      }
    }
    return all;
  }

  [[noreturn]] void refuse(std::string_view wanted) {
    throw BadArray(fmt::format("its header is damaged: {} at {}", wanted,
                               rest_.empty() ? "its end" : quote(shortened(rest_, 40))));
  }

 private:
  void skip_blanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\n"), rest_.size()));
  }

  std::string_view rest_;
};

/// "<f8", "|V4", "<M8[ns]"; characters of U are four bytes.
NumpyType type_of(const std::string& spelled) {
  constexpr std::string_view orders = "<>|=";
  NumpyType type{.spelled = spelled};
  std::string_view rest = spelled;
  if (!rest.empty() && orders.find(rest.front()) != orders.npos) {
    type.big_endian = rest.front() == '>';
    rest.remove_prefix(1);
  }
  type.kind = rest.empty() ? '?' : rest.front();
  rest.remove_prefix(std::min<std::size_t>(1, rest.size()));
  if (type.kind == 'O')
    throw BadArray(fmt::format("it holds Python objects (dtype {}); numbers were expected",
                               quote(shortened(spelled, 40))));
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), type.width);
  const bool whole = error == std::errc{} && (end == rest.data() + rest.size() || *end == '[');
  if (!whole || type.width > (std::uint64_t{1} << 32))
    throw BadArray(
        fmt::format("its header is damaged: {} is no dtype", quote(shortened(spelled, 40))));
  if (type.kind == 'U') type.width *= 4;
  return type;
}

NumpyField field_in(NpyDictionary& words, std::uint64_t offset) {
  words.expect('(');
  NumpyField field;
  if (words.takes('(')) {  // a title and a name
    (void)words.text();
    words.expect(',');
    field.name = words.text();
    words.expect(')');
  } else {
    field.name = words.text();
  }
  words.expect(',');
  field.offset = offset;
  field.type = type_of(words.text());
  if (words.takes(',')) {
    for (const std::uint64_t times : words.counts()) {
      if (times > 0 && field.type.width > (std::uint64_t{1} << 32) / times)
        throw BadArray(fmt::format("its header is damaged: {} of {} elements",
                                   quote(shortened(field.name, 40)), times));
      field.type.width *= times;
    }
    field.type.kind = 'a';  // an array in each record
  }
  words.expect(')');
  return field;
}

void read_descr(NpyDictionary& words, NpyHeader& header) {
  header.of_records = words.takes('[');
  if (!header.of_records) {
    header.fields.push_back({.name = "", .type = type_of(words.text())});
    header.width = header.fields.front().type.width;
    return;
  }
  while (!words.takes(']')) {
    header.fields.push_back(field_in(words, header.width));
    header.width += header.fields.back().type.width;
    if (!words.takes(',')) {
      words.expect(']');
      break;
    }
  }
}

NpyHeader dictionary(std::string_view text) {
  NpyDictionary words(text);
  NpyHeader header;
  std::vector<std::string> keys;
  words.expect('{');
  while (!words.takes('}')) {
    keys.push_back(words.text());
    words.expect(':');
    if (keys.back() == "descr")
      read_descr(words, header);
    else if (keys.back() == "fortran_order")
      header.fortran_order = words.truth();
    else if (keys.back() == "shape")
      header.shape = words.counts();
    else
      words.refuse("descr, fortran_order or shape was expected");
    if (!words.takes(',')) {
      words.expect('}');
      break;
    }
  }
  if (!words.done()) words.refuse("nothing more was expected");
  std::ranges::sort(keys);
  if (keys != std::vector<std::string>{"descr", "fortran_order", "shape"})
    throw BadArray(
        "its header is damaged: descr, fortran_order and shape were expected, each once");
  return header;
}

/// How many elements, unless they are more than 2^63 bytes.
std::uint64_t count_of(const NpyHeader& header) {
  constexpr std::uint64_t most = std::uint64_t{1} << 63;
  if (std::ranges::find(header.shape, 0u) != header.shape.end()) return 0;
  std::uint64_t count = 1;
  for (const std::uint64_t length : header.shape) {
    if (length > most / std::max<std::uint64_t>(header.width, 1) / count)
      throw BadArray(fmt::format("it claims shape {} of {} bytes each; no file holds so much",
                                 numpy_shape(header.shape), header.width));
    count *= length;
  }
  return count;
}

void require_all_there(const NpyHeader& header, std::string_view bytes) {
  const std::uint64_t claimed = header.count * header.width, there = bytes.size() - header.begin;
  if (claimed == there) return;
  throw BadArray(fmt::format("it claims shape {} of {} bytes each, {} bytes; {} are there",
                             numpy_shape(header.shape), header.width, claimed, there));
}

}  // namespace

std::string numpy_shape(const std::vector<std::uint64_t>& shape) {
  return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

NpyHeader read_npy_header(std::string_view bytes) {
  if (!bytes.starts_with(magic)) throw BadArray("it is not an .npy array: other first bytes");
  const std::uint64_t version = little_endian(bytes, magic.size(), 1);
  if (version < 1 || version > 3)
    throw BadArray(fmt::format("it is an .npy array of version {}; 1 to 3 can be read", version));
  const unsigned width = version == 1 ? 2 : 4;
  const std::uint64_t length = little_endian(bytes, magic.size() + 2, width);
  const std::uint64_t begin = magic.size() + 2 + width;
  NpyHeader header = dictionary(piece(bytes, begin, length));
  header.begin = begin + length;
  header.count = count_of(header);
  require_all_there(header, bytes);
  return header;
}

}  // namespace vortree::io
