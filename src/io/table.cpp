#include "io/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "io/files.hpp"

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

std::vector<double> row_of(std::string_view line, const Table& table, int line_number) {
  const auto refuse = [&](const std::string& words) {
    throw InputError(fmt::format("{}:{}: {}", table.path.string(), line_number, words));
  };
  const std::vector<std::string_view> cells = cells_of(line);
  if (cells.size() != table.columns.size()) {
    refuse(fmt::format("{} cells; {} columns were expected", cells.size(), table.columns.size()));
  }
  std::vector<double> row;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto value =
        cells[i].empty() ? std::numeric_limits<double>::quiet_NaN() : number(cells[i]);
    if (!value)
      refuse(fmt::format("{} is \"{}\"; a number was expected", table.columns[i], cells[i]));
    row.push_back(*value);
  }
  return row;
}

}  // namespace

std::optional<double> number(std::string_view text) {
  text = trimmed(text);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Table read_table(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  Table table{.path = path, .columns = {}, .rows = {}};
  int line_number = 0;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++line_number;
    if (line.empty() || line.front() == '#') continue;
    if (table.columns.empty()) {
      for (const std::string_view cell : cells_of(line)) table.columns.emplace_back(cell);
    } else {
      table.rows.push_back(row_of(line, table, line_number));
    }
  }
  if (table.columns.empty()) {
    throw InputError(
        fmt::format("{} is empty; a line of column names was expected", path.string()));
  }
  return table;
}

std::vector<double> Table::column(const std::string& name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) {
    throw InputError(fmt::format("{}: there is no column {}; the file has {}", path.string(), name,
                                 fmt::join(columns, ", ")));
  }
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(row[found - columns.begin()]);
  return values;
}

}  // namespace vortree::io
