#include "io/tables/table_mark.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/frames/checksum.hpp"
#include "io/tables/table.hpp"

namespace vortree::io {
namespace {

std::string_view first_line(std::string_view text) {
  return text.substr(0, std::min(text.find('\n'), text.size()));
}

}  // namespace

void TableMark::add(std::string_view line) {
  Checksum sum;
  sum.add(checksum);
  sum.add(line);
  checksum = sum.value();
  rows += bytes > 0;
  bytes += line.size() + 1;
}

std::vector<double> as_numbers(const TableMark& mark) {
  return {static_cast<double>(mark.rows), static_cast<double>(mark.bytes),
          static_cast<double>(mark.checksum >> 32),
          static_cast<double>(mark.checksum & 0xffffffffU)};
}

std::optional<TableMark> mark_of(std::span<const double> numbers) {
  constexpr double most = 9007199254740992.0;  // 2^53
  const auto whole = [](double value) { return value >= 0 && value < most; };
  if (numbers.size() != 4 || !std::ranges::all_of(numbers, whole)) return std::nullopt;
  const auto part = [&](std::size_t k) { return static_cast<std::uint64_t>(numbers[k]); };
  return TableMark{.rows = part(0), .bytes = part(1), .checksum = part(2) << 32 | part(3)};
}

bool begins_with(std::string_view text, const TableMark& mark) {
  if (text.size() < mark.bytes) return false;
  text = text.substr(0, mark.bytes);
  TableMark found;
  while (!text.empty() && text.find('\n') != std::string_view::npos) {
    const std::string_view line = first_line(text);
    found.add(line);
    text.remove_prefix(line.size() + 1);
  }
  return found == mark;
}

TableMark counted(const std::filesystem::path& file, std::string_view text,
                  std::span<const double> expected) {
  TableMark mark;
  const auto cells = [](std::string_view line) { return std::ranges::count(line, ',') + 1; };
  const std::string_view names = first_line(text);
  for (std::size_t k = 0; k <= expected.size(); ++k) {
    const std::size_t end = text.find('\n');
    const std::string_view line = first_line(text);
    const auto time = number(line.substr(0, line.find(',')));
    const bool whole = end != std::string_view::npos && cells(line) == cells(names);
    if (!whole || (k > 0 && time != expected[k - 1])) {
      throw InputError(fmt::format(
          "{}:{}: {}; {} was expected", file.string(), k + 1,
          line.empty() ? "nothing" : fmt::format("\"{}\"", line.substr(0, 40)),
          k == 0 ? "a line of names" : fmt::format("the row of t = {}", expected[k - 1])));
    }
    mark.add(line);
    text.remove_prefix(end + 1);
  }
  const std::string_view next = first_line(text);
  const auto later = number(next.substr(0, next.find(',')));
  if (later && !expected.empty() && *later <= expected.back()) {
    throw InputError(
        fmt::format("{}:{}: a row of t = {} too many", file.string(), expected.size() + 2, *later));
  }
  return mark;
}

}  // namespace vortree::io
