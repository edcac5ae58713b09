#include "io/tables/table_mark.hpp"

#include <algorithm>

#include "io/frames/checksum.hpp"

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

}  // namespace vortree::io
