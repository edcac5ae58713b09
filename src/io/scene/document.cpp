#include "io/scene/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "io/input_error.hpp"
#include "io/quote.hpp"
#include "io/scene/toml_text.hpp"

namespace vortree::io {
namespace {

/// An override as errors show it.
std::string typed(std::string_view override) {
  return "command line: " + shortened(override, 80);
}

toml::table parse_text(std::string_view text, const std::filesystem::path& path) {
  if (text.size() > longest_scene) {
    throw InputError(fmt::format("{} has {} bytes; a scene has {} at most", path.string(),
                                 text.size(), longest_scene));
  }
  if (const auto bad = unfit_for_toml(text)) {
    throw InputError(fmt::format("{}:{}: not TOML: {}", path.string(), bad->line, bad->words));
  }
  try {
    return toml::parse(text, std::string_view());
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: not TOML: {}", path.string(), error.source().begin.line,
                                 error.description()));
  }
}

/// A word is what a shell user types without quotes: boxes, reference/drag.csv, Two vortices.
bool is_bare_string(std::string_view text) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) || std::string_view("_-./ ").find(c) != std::string_view::npos;
  };
  const unsigned char first = text.front();
  return (std::isalpha(first) || first == '_' || first == '.' || first == '/') &&
         std::all_of(text.begin(), text.end(), is_plain);
}

/// A table with the one key "value".
toml::table parse_value(const std::string& override, std::string_view value) {
  if (value.empty()) {
    throw InputError(typed(override) + ": there is no value behind the =");
  }
  if (override.size() > longest_scene) throw InputError(typed(override) + ": too long");
  if (const auto bad = unfit_for_toml(value)) {
    throw InputError(fmt::format("{}: not a TOML value: {}", typed(override), bad->words));
  }
  try {
    return toml::parse(fmt::format("value = {}", value), std::string_view());
  } catch (const toml::parse_error& error) {
    if (is_bare_string(value)) return toml::table{{"value", std::string(value)}};
    throw InputError(fmt::format("{}: not a TOML value: {}", typed(override), error.description()));
  }
}

}  // namespace

std::string_view kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a floating-point number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

Document::Document(std::string_view text, std::filesystem::path path,
                   std::span<const std::string> overrides)
    : path_(std::move(path)), root_(parse_text(text, path_)) {
  if (root_.empty()) {
    throw InputError(
        fmt::format("{} is empty; a scene needs [flow], [cores] and [time]", path_.string()));
  }
  for (const std::string& override : overrides) lay_over(override);
}

void Document::lay_over(const std::string& override) {
  if (override.find('\n') != std::string::npos) {
    throw InputError(fmt::format("{}...: an override is one line",
                                 typed(override.substr(0, override.find('\n')))));
  }
  const std::size_t equals = override.find('=');
  std::string key = override.substr(0, equals);
  key.erase(key.find_last_not_of(' ') + 1);
  if (equals == std::string::npos || key.empty()) {
    throw InputError(typed(override) + ": an override is written table.key=value");
  }
  const toml::table parsed = parse_value(override, std::string_view(override).substr(equals + 1));
  lay_over(key, *parsed.get("value"), override);
}

void Document::lay_over(const std::string& key, const toml::node& value,
                        const std::string& override) {
  overrides_[key] = override;
  const std::size_t dot = key.find('.');
  if (dot != std::string::npos) return set(key.substr(0, dot), key.substr(dot + 1), value);
  if (!value.is_table()) {
    root_.insert_or_assign(key, value);
    return;
  }
  root_.insert(key, toml::table{});
  for (const auto& [name, inside] : *value.as_table())
    lay_over(fmt::format("{}.{}", key, name.str()), inside, override);
}

void Document::set(const std::string& table, std::string_view key, const toml::node& value) {
  toml::node& parent = root_.insert(table, toml::table{}).first->second;
  if (!parent.is_table()) {
    refuse(table, fmt::format("{} is {}; a table was expected", table, kind_of(parent)));
  }
  parent.as_table()->insert_or_assign(key, value);
}

std::string Document::place(std::string_view key) const {
  if (const auto found = overrides_.find(key); found != overrides_.end()) {
    return typed(found->second);
  }
  const std::size_t dot = key.find('.');
  const toml::node* node = root_.get(key);
  if (!node && dot != std::string_view::npos) {
    const toml::node* table = root_.get(key.substr(0, dot));
    if (table && table->is_table()) node = table->as_table()->get(key.substr(dot + 1));
  }
  if (node && node->source().begin.line > 0) {
    return fmt::format("{}:{}", path_.string(), node->source().begin.line);
  }
  // A table that only the command line knows: the first override inside it.
  const auto inside = overrides_.lower_bound(fmt::format("{}.", key));
  if (inside != overrides_.end() && inside->first.starts_with(fmt::format("{}.", key))) {
    return typed(inside->second);
  }
  return dot == std::string_view::npos ? path_.string() : place(key.substr(0, dot));
}

void Document::refuse(std::string_view key, std::string_view words) const {
  throw InputError(fmt::format("{}: {}", place(key.substr(0, key.find('['))), words));
}

}  // namespace vortree::io
