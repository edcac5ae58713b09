#include "io/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace vortree::io {
namespace {

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> result;
  std::stringstream in(line);
  for (std::string field; std::getline(in, field, ',');) result.push_back(field);
  return result;
}

}  // namespace

Table::Table(const std::filesystem::path& file) : file_(file) {
  std::ifstream in(file);
  if (!in) throw InputError(fmt::format("{}: cannot be read", file.string()));
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const auto words = fields(line);
    if (names_.empty()) {
      names_ = words;
      continue;
    }
    if (words.size() != names_.size())
      throw InputError(fmt::format("{}:{}: {} values; {} columns were expected", file.string(),
                                   number, words.size(), names_.size()));
    for (const std::string& word : words) {
      char* end = nullptr;
      values_.push_back(std::strtod(word.c_str(), &end));
      if (end == word.c_str())
        throw InputError(
            fmt::format("{}:{}: '{}' is not a number", file.string(), number, word));
    }
  }
  if (names_.empty()) throw InputError(fmt::format("{}: no line of column names", file.string()));
}

bool Table::has(std::string_view column) const { return std::ranges::count(names_, column) > 0; }

std::vector<double> Table::column(std::string_view name) const {
  const auto found = std::ranges::find(names_, name);
  if (found == names_.end())
    throw InputError(fmt::format("{}: no column {}", file_.string(), name));
  const auto k = static_cast<std::size_t>(found - names_.begin());
  std::vector<double> result;
  for (std::size_t row = 0; row < rows(); ++row) result.push_back(values_[row * names_.size() + k]);
  return result;
}

}  // namespace vortree::io
