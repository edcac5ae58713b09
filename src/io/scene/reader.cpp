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

using schema::Rule;

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
    return std::string_view(name).substr(0, name.find('['));
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

void read(const Value& value, double& target, const Rule& rule) {
  if (!value.node.is_number()) value.expected("a number");
  target = *value.node.value<double>();
  if (!std::isfinite(target)) {
    value.refuse(value.base(),
                 fmt::format("{} is {}; a finite number was expected", value.name, target));
  }
  hold(value, target, rule);
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

template <class E>
requires std::is_enum_v<E>
void read(const Value& value, E& target, const Rule& rule) {
  std::string text;
  read(value, text, rule);
  const auto& words = schema::words_of<E>;
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end()) {
    value.refuse(value.name,
                 fmt::format("{} is {}; known: {}", value.name, as_typed(text), listed(words)));
  }
  target = static_cast<E>(found - words.begin());
}

template <class T>
void read(const Value& value, std::optional<T>& target, const Rule& rule) {
  read(value, target.emplace(), rule);
}

/// Collects the names of a table's keys, or of a scene's keys and tables.
struct Names {
  std::vector<std::string_view> keys, tables;

  void operator()(std::string_view key, const auto&, const Rule&) { keys.push_back(key); }
  void table(std::string_view name, const auto&, bool) { tables.push_back(name); }
};

template <class T>
Names names_of() {
  Names names;
  const T blank{};
  schema::walk(blank, names);
  return names;
}

bool contains(const std::vector<std::string_view>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string advice(std::string_view word, std::span<const std::string_view> known) {
  constexpr std::size_t longer_than_any_key = 64;
  word = word.substr(0, longer_than_any_key);
  const std::string_view meant = nearest(word, known);
  return fmt::format("known: {}{}", listed(known, word),
                     meant.empty() ? "" : fmt::format("; did you mean {}?", meant));
}

/// Reads the keys of one table as the schema walks past them.
struct TableReader {
  const Document& document;
  std::string name;
  const toml::table& table;

  template <class T>
  void operator()(std::string_view key, T& target, const Rule& rule) {
    if (const toml::node* node = table.get(key)) {
      read(Value{document, fmt::format("{}.{}", name, key), *node}, target, rule);
    } else if (rule.required) {
      document.refuse(name, fmt::format("[{}] needs the key {}", name, key));
    }
  }

  void refuse_unknown(const std::vector<std::string_view>& known) const {
    for (const auto& [key, node] : table) {
      if (contains(known, key.str())) continue;
      const std::string dotted = fmt::format("{}.{}", name, key.str());
      document.refuse(dotted, fmt::format("{} is not a key of [{}]; {}", shortened(dotted, 80),
                                          name, advice(key.str(), known)));
    }
  }
};

struct SceneReader {
  const Document& document;

  template <class T>
  void operator()(std::string_view key, T& target, const Rule& rule) {
    if (const toml::node* node = document.root().get(key)) {
      read(Value{document, std::string(key), *node}, target, rule);
    }
  }

  template <class T>
  void table(std::string_view name, T& target, bool required) {
    const toml::node* node = document.root().get(name);
    if (!node && required) document.refuse("", fmt::format("the table [{}] is missing", name));
    if (!node) return;
    if (!node->is_table()) {
      document.refuse(name, fmt::format("{} is {}; a table was expected", name, kind_of(*node)));
    }
    TableReader reader{document, std::string(name), *node->as_table()};
    reader.refuse_unknown(names_of<T>().keys);
    schema::walk(target, reader);
  }

  template <class T>
  void table(std::string_view name, std::optional<T>& target, bool required) {
    if (document.root().contains(name)) table(name, target.emplace(), required);
  }

  void refuse_unknown() const {
    const Names known = names_of<Scene>();
    for (const auto& [key, node] : document.root()) {
      if (contains(known.keys, key.str()) || contains(known.tables, key.str())) continue;
      const std::string name(key.str()), shown = shortened(name, 80);
      document.refuse(name, node.is_table()
                                ? fmt::format("[{}] is not a table of a scene; {}", shown,
                                              advice(name, known.tables))
                                : fmt::format("{} is not a key at the top of a scene; {}", shown,
                                              advice(name, known.keys)));
    }
  }
};

}  // namespace

Scene read_scene(const Document& document) {
  Scene scene;
  SceneReader reader{document};
  reader.refuse_unknown();
  schema::walk(scene, reader);
  return scene;
}

}  // namespace vortree::io
