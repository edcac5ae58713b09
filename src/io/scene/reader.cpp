#include "io/scene/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "io/quote.hpp"
#include "io/scene/schema.hpp"
#include "io/suggestion.hpp"

namespace vortree::io {
namespace {

/// One value under its dotted name; the overloads of `read` convert it and hold it to the rule.
struct Value {
  const Document& document;
  std::string name;
  const toml::node& node;

  [[noreturn]] void refuse(std::string_view key, std::string_view words) const {
    document.refuse(key, words);
  }
  [[noreturn]] void expected(std::string_view what) const {
    document.refuse(base(), fmt::format("{} is {}; {} was expected", name, kind_of(node), what));
  }
  /// flow.stream for flow.stream[1]: the place of an element is the place of its array.
  [[nodiscard]] std::string_view base() const {
    std::string_view all = name;
    while (all.ends_with(']')) all = all.substr(0, all.rfind('['));
    return all;
  }
  [[nodiscard]] Value element(std::size_t i) const {
    return {document, fmt::format("{}[{}]", name, i), (*node.as_array())[i]};
  }
};

/// A text of the user's as errors show it.
std::string as_typed(std::string_view text) {
  return quote(shortened(text, 60));
}

void hold(const Value& value, double number, const Rule& rule) {
  if (!rule.holds(number)) {
    value.refuse(value.base(), fmt::format("{} is {}; {}", value.name, number, rule.words));
  }
}

/// An integer that no double holds counts as the double nearest to it.
double nearest_double(const toml::node& number) {
  if (number.is_integer()) return static_cast<double>(number.as_integer()->get());
  return number.as_floating_point()->get();
}

void read(const Value& value, double& target, const Rule& rule) {
  if (!value.node.is_number()) value.expected("a number");
  target = nearest_double(value.node);
  if (!std::isfinite(target)) {
    value.refuse(value.base(),
                 fmt::format("{} is {}; a finite number was expected", value.name, target));
  }
  hold(value, target, rule);
}

void read(const Value& value, bool& target, const Rule&) {
  if (!value.node.is_boolean()) value.expected("true or false");
  target = value.node.as_boolean()->get();
}

void read(const Value& value, std::int64_t& target, const Rule& rule) {
  if (!value.node.is_integer()) value.expected("an integer");
  target = value.node.as_integer()->get();
  hold(value, static_cast<double>(target), rule);
}

void read(const Value& value, int& target, const Rule& rule) {
  std::int64_t wide = 0;
  read(value, wide, rule);
  if (wide > std::numeric_limits<int>::max()) {
    value.refuse(value.base(), fmt::format("{} is {}; it must be <= {}", value.name, wide,
                                           std::numeric_limits<int>::max()));
  }
  target = static_cast<int>(wide);
}

void read(const Value& value, std::string& target, const Rule&) {
  if (!value.node.is_string()) value.expected("a string");
  target = value.node.as_string()->get();
}

void read(const Value& value, std::vector<double>& target, const Rule& rule) {
  if (!value.node.is_array()) value.expected("an array of numbers");
  target.resize(value.node.as_array()->size());
  for (std::size_t i = 0; i < target.size(); ++i) read(value.element(i), target[i], rule);
}

template <std::size_t n>
void read(const Value& value, std::array<double, n>& target, const Rule& rule) {
  const std::string what = fmt::format("an array of {} numbers", n);
  if (!value.node.is_array()) value.expected(what);
  if (const std::size_t found = value.node.as_array()->size(); found != n) {
    value.refuse(value.name,
                 fmt::format("{} has {} elements; {} was expected", value.name, found, what));
  }
  for (std::size_t i = 0; i < n; ++i) read(value.element(i), target[i], rule);
}

void read(const Value& value, std::vector<Pair>& target, const Rule& rule) {
  if (!value.node.is_array()) value.expected("an array of arrays of 2 numbers");
  target.resize(value.node.as_array()->size());
  for (std::size_t i = 0; i < target.size(); ++i) read(value.element(i), target[i], rule);
}

void read(const Value& value, const OneOf& target, const Rule& rule) {
  std::string text;
  read(value, text, rule);
  const auto found = std::ranges::find(target.words, text);
  if (found == target.words.end()) {
    value.refuse(value.name, fmt::format("{} is {}; known: {}", value.name, as_typed(text),
                                         listed(target.words)));
  }
  target.set(static_cast<std::size_t>(found - target.words.begin()));
}

template <class T>
void read(const Value& value, std::optional<T>& target, const Rule& rule) {
  read(value, target.emplace(), rule);
}

template <class T>
void read(const Value& value, T* target, const Rule& rule) {
  read(value, *target, rule);
}

void read_table(const Document& document, std::string_view name, const toml::table& table,
                const std::vector<Key>& keys);

void read(const Value& value, const ListOfTables& target, const Rule&) {
  const toml::array* all = value.node.as_array();
  if (!all || !all->is_homogeneous(toml::node_type::table)) {
    if (!all || !all->empty()) value.expected("an array of tables");
  }
  target.resize(all->size());
  for (std::size_t i = 0; i < all->size(); ++i) {
    const Value one = value.element(i);
    read_table(value.document, one.name, *one.node.as_table(), target.keys(i));
  }
}

void read(const Value& value, const InnerTable& target, const Rule&) {
  if (!value.node.is_table()) value.expected("a table");
  read_table(value.document, value.name, *value.node.as_table(), target.keys());
}

void read(const Value& value, const Key& key) {
  std::visit([&](const auto& target) { read(value, target, key.rule); }, key.target);
}

using Names = std::vector<std::string_view>;

/// The names of keys, or of tables.
Names names_of(const auto& list) {
  Names names;
  for (const auto& named : list) names.push_back(named.name);
  return names;
}

bool contains(const Names& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string advice(std::string_view word, std::span<const std::string_view> known) {
  constexpr std::size_t longer_than_any_key = 64;
  word = word.substr(0, longer_than_any_key);
  const std::string_view meant = nearest(word, known);
  return fmt::format("known: {}{}", listed(known, word),
                     meant.empty() ? "" : fmt::format("; did you mean {}?", meant));
}

void refuse_unknown(const Document& document, std::string_view name, const toml::table& table,
                    const Names& known) {
  for (const auto& [key, node] : table) {
    if (contains(known, key.str())) continue;
    const std::string dotted = fmt::format("{}.{}", name, key.str());
    document.refuse(dotted, fmt::format("{} is not a key of [{}]; {}", shortened(dotted, 80), name,
                                        advice(key.str(), known)));
  }
}

void refuse_unknown(const Document& document, const Names& keys, const Names& tables) {
  for (const auto& [key, node] : document.root()) {
    if (contains(keys, key.str()) || contains(tables, key.str())) continue;
    const std::string name(key.str()), shown = shortened(name, 80);
    document.refuse(name, node.is_table() ? fmt::format("[{}] is not a table of a scene; {}", shown,
                                                        advice(name, tables))
                                          : fmt::format("{} is not a key at the top of a scene; {}",
                                                        shown, advice(name, keys)));
  }
}

void read_table(const Document& document, std::string_view name, const toml::table& table,
                const std::vector<Key>& keys) {
  refuse_unknown(document, name, table, names_of(keys));
  for (const Key& key : keys) {
    if (const toml::node* node = table.get(key.name)) {
      read(Value{document, fmt::format("{}.{}", name, key.name), *node}, key);
    } else if (key.rule.required) {
      document.refuse(name, fmt::format("[{}] needs the key {}", name, key.name));
    }
  }
}

/// With the keys that have no default.
[[noreturn]] void refuse_missing(const Document& document, const SceneTable& table) {
  std::vector<Key> wanted = table.keys();
  std::erase_if(wanted, [](const Key& key) { return !key.rule.required && !key.rule.chosen; });
  document.refuse("", fmt::format("the table [{}] is missing; [{}] with {} was expected",
                                  table.name, table.name, listed(names_of(wanted))));
}

/// The first into its own place, those after it into theirs.
void read_list(const Document& document, const SceneTable& table, const toml::array& all) {
  if (!all.is_homogeneous(toml::node_type::table))
    document.refuse(table.name,
                    fmt::format("{} is an array; tables were expected in it", table.name));
  table.others->resize(all.size() - 1);
  for (std::size_t k = 0; k < all.size(); ++k)
    read_table(document, fmt::format("{}[{}]", table.name, k), *all[k].as_table(),
               k == 0 ? table.keys() : table.others->keys(k - 1));
}

void read_table(const Document& document, const SceneTable& table) {
  const toml::node* node = document.root().get(table.name);
  if (!node && table.required) refuse_missing(document, table);
  if (!node) return;
  if (table.others && node->is_array() && !node->as_array()->empty())
    return read_list(document, table, *node->as_array());
  if (!node->is_table()) {
    document.refuse(table.name,
                    fmt::format("{} is {}; a table was expected", table.name, kind_of(*node)));
  }
  read_table(document, table.name, *node->as_table(), table.keys());
}

void refuse_unknown_method(const Document& document, const Scene& scene) {
  Names known;
  for (const flow::AnyMethod& method : scene.methods) known.push_back(method->name());
  if (!contains(known, scene.method))
    document.refuse("method", fmt::format("method is {}; known: {}",
                                          quote(shortened(scene.method, 60)), listed(known)));
}

}  // namespace

Scene read_scene(const Document& document, const flow::Methods& methods) {
  Scene scene = blank_scene(methods);
  const std::vector<Key> top = keys(scene);
  const std::vector<SceneTable> all = tables(scene);
  refuse_unknown(document, names_of(top), names_of(all));
  for (const Key& key : top) {
    if (const toml::node* node = document.root().get(key.name))
      read(Value{document, std::string(key.name), *node}, key);
  }
  refuse_unknown_method(document, scene);
  for (const SceneTable& table : all) read_table(document, table);
  return scene;
}

}  // namespace vortree::io
