#include <fmt/format.h>
#include <fmt/ranges.h>

#include <concepts>
#include <map>
#include <string>
#include <vector>

#include "io/quote.hpp"
#include "io/scene/scene.hpp"
#include "io/scene/schema.hpp"

namespace vortree::io {
namespace {

/// The shortest digits that read back to the same double, with a point or an exponent: a float.
std::string toml_text(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

template <std::integral I>
std::string toml_text(I value) {
  return fmt::format("{}", value);
}

std::string toml_text(const std::string& value) {
  return quote(value);
}

std::string toml_text(std::span<const double> values) {
  std::vector<std::string> words;
  for (const double value : values) words.push_back(toml_text(value));
  return fmt::format("[{}]", fmt::join(words, ", "));
}

std::string in_quotes(std::string_view word) {
  return fmt::format("\"{}\"", word);
}

/// The value of a key as TOML; an optional that is not set has none.
using Text = std::optional<std::string>;

template <class T>
Text text_of(const T* value) {
  return toml_text(*value);
}

template <class T>
Text text_of(const std::optional<T>* value) {
  return *value ? Text(toml_text(**value)) : std::nullopt;
}

Text text_of(const OneOf& choice) {
  const auto number = choice.get();
  return number ? Text(in_quotes(choice.words[*number])) : std::nullopt;
}

/// Nobody has written or chosen it, since what the scene asks for does without.
bool open(const Key& key) {
  const auto* number = std::get_if<double*>(&key.target);
  return key.rule.chosen && number && !key.rule.holds(**number);
}

Text text_of(const Key& key) {
  if (open(key)) return std::nullopt;
  return std::visit([](const auto& target) { return text_of(target); }, key.target);
}

/// `key = value` lines; unset optionals leave no trace.
std::string lines(const std::vector<Key>& keys) {
  std::string all;
  for (const Key& key : keys)
    if (const Text text = text_of(key)) all += fmt::format("{} = {}\n", key.name, *text);
  return all;
}

/// What a key is without being written.
std::string usual(const Key& key) {
  if (key.rule.required) return "needed";
  if (key.rule.chosen) return "chosen";
  return text_of(key).value_or("none");
}

/// "> 0, <= 0.1", "8 .. 64", "a", "b"; nothing where anything goes.
std::string limits(const Key& key) {
  if (const OneOf* choice = std::get_if<OneOf>(&key.target)) {
    std::vector<std::string> words;
    for (const std::string_view word : choice->words) words.push_back(in_quotes(word));
    return fmt::format("{}", fmt::join(words, ", "));
  }
  const Rule& rule = key.rule;
  const bool below = rule.low > -endless, above = rule.high < endless;
  if (below && above && !rule.above_low && !rule.below_high)
    return fmt::format("{} .. {}", rule.low, rule.high);
  const std::string low = fmt::format("{} {}", rule.above_low ? ">" : ">=", rule.low),
                    high = fmt::format("{} {}", rule.below_high ? "<" : "<=", rule.high);
  return (below ? low : "") + (below && above ? ", " : "") + (above ? high : "");
}

std::string row(std::string_view name, const Key& key) {
  return fmt::format("| `{}` | {} | {} | {} | {} |\n", name, usual(key), key.unit, limits(key),
                     key.says);
}

}  // namespace

std::string resolved(const Scene& scene) {
  Scene copy = scene;  // keys are places to write to, too
  std::string text = lines(keys(copy));
  for (const SceneTable& table : tables_that_count(copy))
    if (table.present()) text += fmt::format("\n[{}]\n{}", table.name, lines(table.keys()));
  return text;
}

namespace {

/// The values of all keys that count, as text, by their dotted names; that a table is there counts
/// by its name in brackets.
std::map<std::string, std::string> values(Scene scene) {
  std::map<std::string, std::string> all;
  for (const Key& key : keys(scene)) all[std::string(key.name)] = text_of(key).value_or("");
  for (const SceneTable& table : tables_that_count(scene)) {
    if (!table.present()) continue;
    all[fmt::format("[{}]", table.name)] = "there";
    for (const Key& key : table.keys())
      all[fmt::format("{}.{}", table.name, key.name)] = text_of(key).value_or("");
  }
  return all;
}

}  // namespace

std::string first_difference(const Scene& a, const Scene& b,
                             const std::function<bool(std::string_view name)>& left_out) {
  const auto first = values(a), second = values(b);
  const auto differs = [&](const auto& one, const auto& other) -> std::string {
    for (const auto& [name, value] : one) {
      const auto same = other.find(name);
      if (!left_out(name) && (same == other.end() || same->second != value)) return name;
    }
    return "";
  };
  const std::string name = differs(first, second);
  return name.empty() ? differs(second, first) : name;
}

std::string page_of_keys(const flow::Methods& methods) {
  std::string page =
      "| key | default | unit | limits or words | what it is |\n"
      "|---|---|---|---|---|\n";
  Scene blank = blank_scene(methods);
  for (const Key& key : keys(blank)) page += row(key.name, key);
  for (const SceneTable& table : tables(blank))
    for (const Key& key : table.keys())
      page += row(fmt::format("{}.{}", table.name, key.name), key);
  return page;
}

}  // namespace vortree::io
