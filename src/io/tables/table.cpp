#include "io/tables/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "io/files.hpp"
#include "io/quote.hpp"

namespace vortree::io {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t comma; (comma = line.find(',')) != std::string_view::npos;) {
    cells.push_back(trimmed(line.substr(0, comma)));
    line.remove_prefix(comma + 1);
  }
  cells.push_back(trimmed(line));
  return cells;
}

}  // namespace

std::optional<double> number(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Table::Table(const std::filesystem::path& file, std::span<const std::string_view> only)
    : file_(file) {
  constexpr std::string_view mark = "\xef\xbb\xbf";  // of UTF-8, by some programs
  const std::string text = read_text(file);
  int line_number = 0;
  std::string_view rest = text;
  if (rest.starts_with(mark)) rest.remove_prefix(mark.size());
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++line_number;
    if (line.empty() || line.front() == '#') continue;
    if (names_.empty()) {
      take_names(line, only);
    } else {
      take_row(line, line_number);
    }
  }
  if (names_.empty()) {
    throw InputError(
        fmt::format("{} is empty; a line of column names was expected", file.string()));
  }
}

void Table::take_names(std::string_view line, std::span<const std::string_view> only) {
  for (const std::string_view cell : cells_of(line)) {
    const bool read = only.empty() || std::ranges::find(only, cell) != only.end();
    if (read) read_.push_back(names_.size());
    names_.emplace_back(cell);
  }
}

void Table::take_row(std::string_view line, int line_number) {
  const auto refuse = [&](const std::string& words) {
    throw InputError(fmt::format("{}:{}: {}", file_.string(), line_number, words));
  };
  const std::vector<std::string_view> cells = cells_of(line);
  if (cells.size() != names_.size()) {
    refuse(fmt::format("{} cells; {} columns were expected", cells.size(), names_.size()));
  }
  lines_.push_back(line_number);
  for (const std::size_t i : read_) {
    const auto value =
        cells[i].empty() ? std::numeric_limits<double>::quiet_NaN() : number(cells[i]);
    if (!value) {
      refuse(fmt::format("{} is {}; a number was expected", shortened(names_[i], 40),
                         quote(shortened(cells[i], 40))));
    }
    values_.push_back(*value);
  }
}

bool Table::has(std::string_view column) const {
  return std::find(names_.begin(), names_.end(), column) != names_.end();
}

std::vector<double> Table::column(std::string_view name) const {
  const auto found = std::ranges::find(
      read_, name, [&](std::size_t at) -> std::string_view { return names_[at]; });
  if (found == read_.end()) {
    throw InputError(fmt::format("{}: there is no column {}; the file has {}", file_.string(), name,
                                 shortened(fmt::format("{}", fmt::join(names_, ", ")), 120)));
  }
  const auto at = static_cast<std::size_t>(found - read_.begin());
  std::vector<double> values;
  values.reserve(rows());
  for (std::size_t i = at; i < values_.size(); i += read_.size()) values.push_back(values_[i]);
  return values;
}

}  // namespace vortree::io
