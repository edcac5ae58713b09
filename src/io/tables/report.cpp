#include "io/tables/report.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "io/files.hpp"

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

/// Of a report, empty if there is none. throws InputError if it is no regular file.
std::string report_text(const fs::path& path) {
  if (!fs::exists(path)) return {};
  require_regular_file(path);
  return read_text(path);
}

std::string joined(const std::vector<std::string>& columns) {
  return fmt::format("{}", fmt::join(columns, ","));
}

/// Header and rows as text.
std::string page(const std::vector<std::string>& columns, std::span<const double> rows) {
  std::string text = joined(columns) + '\n';
  for (; !rows.empty(); rows = rows.subspan(columns.size())) {
    text += fmt::format("{}\n", fmt::join(rows.first(columns.size()), ","));
  }
  return text;
}

TableMark mark_of_page(std::string_view text) {
  TableMark mark;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    mark.add(line);
    text.remove_prefix(line.size() + 1);
  }
  return mark;
}

}  // namespace

Report::Report(fs::path path, std::vector<std::string> columns)
    : Report(std::move(path), std::move(columns), std::span<const double>{}) {}

Report::Report(fs::path path, std::vector<std::string> columns, std::span<const double> rows)
    : path_(std::move(path)), columns_(std::move(columns)) {
  if (rows.size() % columns_.size() != 0) {
    throw std::invalid_argument(fmt::format("{}: {} values for rows of {} columns", path_.string(),
                                            rows.size(), columns_.size()));
  }
  require_writable(path_);
  const std::string text = page(columns_, rows);
  write_text(path_, text);
  mark_ = mark_of_page(text);
  file_ = open_to_append(path_);
}

Report::Report(fs::path path, std::vector<std::string> columns, const TableMark& mark)
    : path_(std::move(path)), columns_(std::move(columns)), mark_(mark) {
  file_ = open_to_append(path_);
  if (::ftruncate(file_, static_cast<off_t>(mark_.bytes)) != 0) {
    throw std::runtime_error(
        fmt::format("{} cannot be shortened: {}", path_.string(), std::strerror(errno)));
  }
}

std::optional<Report> Report::resume(fs::path path, std::vector<std::string> columns,
                                     const TableMark& mark) {
  const std::string text = report_text(path);
  if (!begins_with(text, mark)) return std::nullopt;
  if (const std::string header = joined(columns), found = text.substr(0, text.find('\n'));
      found != header) {
    throw InputError(fmt::format("{}:1: the columns are {}; a report with {} cannot go on there",
                                 path.string(), found, header));
  }
  return Report(std::move(path), std::move(columns), mark);
}

void Report::row(std::span<const double> values) {
  if (values.size() != columns_.size()) {
    throw std::invalid_argument(fmt::format("{}: a row of {} values for {} columns", path_.string(),
                                            values.size(), columns_.size()));
  }
  const std::string line = fmt::format("{}", fmt::join(values, ","));
  write_whole(file_, line + '\n', path_);
  mark_.add(line);
  since_.insert(since_.end(), values.begin(), values.end());
  require_alone();
}

void Report::require_alone() const {
  struct stat now = {};
  if (::fstat(file_, &now) == 0 && now.st_nlink > 0 &&
      static_cast<std::uint64_t>(now.st_size) == mark_.bytes) {
    return;
  }
  throw std::runtime_error(
      fmt::format("{} was {} by someone else while it was written; --resume makes it again",
                  path_.string(), now.st_nlink == 0 ? "removed or replaced" : "changed"));
}

void Report::force() const {
  require_alone();
  io::force(file_, path_);
}

std::optional<TableMark> mark_of_rows(const std::vector<std::string>& columns,
                                      std::span<const double> rows) {
  if (rows.size() % columns.size() != 0) return std::nullopt;
  return mark_of_page(page(columns, rows));
}

}  // namespace vortree::io
