#include "io/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "io/files.hpp"
#include "io/table.hpp"

namespace vortree::io {
namespace {

/// The text up to the last row that was written to its end and is not later than `until`.
std::string rows_until(std::string_view text, double until) {
  std::string kept;
  bool header = true;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) break;
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    if (!header) {
      const auto time = number(line.substr(0, line.find(',')));
      if (!time || *time > until) continue;
    }
    kept.append(line).append("\n");
    header = false;
  }
  return kept;
}

}  // namespace

Report::Report(std::filesystem::path path, std::vector<std::string> columns)
    : path_(std::move(path)), columns_(std::move(columns)) {
  require_writable(path_);
  write_text(path_, fmt::format("{}\n", fmt::join(columns_, ",")));
  open();
}

Report::Report(Continue, std::filesystem::path path, std::vector<std::string> columns)
    : path_(std::move(path)), columns_(std::move(columns)) {
  open();
}

void Report::open() {
  out_.open(path_, std::ios::app);
  if (!out_) {
    throw InputError(fmt::format("{} cannot be written: {}", path_.string(), std::strerror(errno)));
  }
}

Report Report::resume(std::filesystem::path path, std::vector<std::string> columns, double until) {
  const std::string text = std::filesystem::exists(path) ? read_text(path) : "";
  const std::string kept = rows_until(text, until);
  if (kept.empty()) return Report(std::move(path), std::move(columns));
  const std::string header = fmt::format("{}", fmt::join(columns, ","));
  const std::string found = kept.substr(0, kept.find('\n'));
  if (found != header) {
    throw InputError(fmt::format("{}:1: the columns are {}; a report with {} cannot go on there",
                                 path.string(), found, header));
  }
  write_text(path, kept);
  return Report(Continue{}, std::move(path), std::move(columns));
}

void Report::row(std::span<const double> values) {
  if (values.size() != columns_.size()) {
    throw std::invalid_argument(fmt::format("{}: a row of {} values for {} columns", path_.string(),
                                            values.size(), columns_.size()));
  }
  out_ << fmt::format("{}\n", fmt::join(values, ",")) << std::flush;
  if (!out_) throw std::runtime_error(fmt::format("{} cannot be written", path_.string()));
}

}  // namespace vortree::io
