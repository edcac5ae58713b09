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

constexpr int most_dots = 4;

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
  if (std::ranges::count(key, '.') > most_dots)
    throw InputError(
        fmt::format("{}: no key of a scene has more than {} dots", typed(override), most_dots));
  const toml::table parsed = parse_value(override, std::string_view(override).substr(equals + 1));
  lay_over(key, *parsed.get("value"), override);
}

void Document::lay_over(const std::string& key, const toml::node& value,
                        const std::string& override) {
  overrides_[key] = override;
  if (key.find('.') != std::string::npos) return set(root_, "", key, value);
  if (!value.is_table()) {
    root_.insert_or_assign(key, value);
    return;
  }
  root_.insert(key, toml::table{});
  for (const auto& [name, inside] : *value.as_table())
    lay_over(fmt::format("{}.{}", key, name.str()), inside, override);
}

/// Into the table of the name that the key begins with, or what of it is named further on.
void Document::set(toml::table& in, const std::string& within, std::string_view key,
                   const toml::node& value) {
  const std::size_t dot = key.find('.');
  if (dot == std::string_view::npos) return void(in.insert_or_assign(key, value));
  const std::string_view step = key.substr(0, dot);
  const std::size_t bracket = std::min(step.find('['), step.size());
  const std::string_view bare = step.substr(0, bracket), number = step.substr(bracket);
  const std::string name = within + std::string(bare);
  toml::node& found = in.insert(bare, toml::table{}).first->second;
  if (found.is_array()) return set_in_list(found, name, number, key.substr(dot + 1), value);
  if (!found.is_table() || !number.empty())
    refuse(name, fmt::format("{} is {}; a {}table was expected", name, kind_of(found),
                             number.empty() ? "" : "list with such a "));
  set(*found.as_table(), name + ".", key.substr(dot + 1), value);
}

/// Into each table of a list, or the one of this number, "[1]".
void Document::set_in_list(toml::node& list, const std::string& name, std::string_view number,
                           std::string_view key, const toml::node& value) {
  toml::array& all = *list.as_array();
  bool met = false;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!all[k].is_table())
      refuse(name, fmt::format("{} is {}; a table was expected", name, kind_of(list)));
    const std::string own = fmt::format("[{}]", k);
    if (!number.empty() && number != own) continue;
    met = true;
    set(*all[k].as_table(), name + own + ".", key, value);
  }
  if (!met)
    refuse(name, fmt::format("{}{} is none of the {} that there are, which count from 0", name,
                             number, all.size()));
}

namespace {

/// What a key is in: flow.stream of flow.stream[1], body[1] of body[1].radius; "" of flow.
std::string_view outside(std::string_view key) {
  const std::size_t end = key.find_last_of(".[");
  return key.substr(0, end == std::string_view::npos ? 0 : end);
}

/// As one that names all tables of a list would have it: body.radius of body[1].radius.
std::string without_numbers(std::string_view key) {
  std::string all;
  bool within = false;
  for (const char c : key) {
    within = c == '[' || (within && c != ']');
    if (!within && c != ']') all += c;
  }
  return all;
}

}  // namespace

std::string Document::place(std::string_view key) const {
  if (key.empty()) return path_.string();
  for (const std::string& name : {std::string(key), without_numbers(key)})
    if (const auto found = overrides_.find(name); found != overrides_.end())
      return typed(found->second);
  const toml::node* quoted = root_.get(key);  // "a.b" = 1
  const toml::node* node = quoted ? quoted : root_.at_path(key).node();
  if (node && node->source().begin.line > 0)
    return fmt::format("{}:{}", path_.string(), node->source().begin.line);
  // A table that only the command line knows: the first override inside it.
  const auto inside = overrides_.lower_bound(fmt::format("{}.", key));
  if (inside != overrides_.end() && inside->first.starts_with(fmt::format("{}.", key))) {
    return typed(inside->second);
  }
  return place(outside(key));
}

void Document::refuse(std::string_view key, std::string_view words) const {
  throw InputError(fmt::format("{}: {}", place(key), words));
}

}  // namespace vortree::io
