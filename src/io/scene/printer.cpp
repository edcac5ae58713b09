#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <string>
#include <utility>
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

std::string toml_text(const std::vector<Pair>& pairs) {
  std::vector<std::string> words;
  for (const Pair& pair : pairs) words.push_back(toml_text(std::span<const double>(pair)));
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

Text text_of(const ListOfTables& list);
Text text_of(const InnerTable& table);

/// Nobody has written or chosen it, since what the scene asks for does without.
bool open(const Key& key) {
  const auto* number = std::get_if<double*>(&key.target);
  return key.rule.chosen && number && !key.rule.holds(**number);
}

Text text_of(const Key& key) {
  if (open(key)) return std::nullopt;
  return std::visit([](const auto& target) { return text_of(target); }, key.target);
}

/// {key = value, ...}
std::string inline_table(const std::vector<Key>& keys) {
  std::vector<std::string> words;
  for (const Key& key : keys)
    if (const Text text = text_of(key)) words.push_back(fmt::format("{} = {}", key.name, *text));
  return fmt::format("{{{}}}", fmt::join(words, ", "));
}

Text text_of(const ListOfTables& list) {
  std::vector<std::string> tables;
  for (std::size_t i = 0; i < list.size(); ++i) tables.push_back(inline_table(list.keys(i)));
  return fmt::format("[{}]", fmt::join(tables, ", "));
}

Text text_of(const InnerTable& table) {
  return table.present() ? Text(inline_table(table.keys())) : std::nullopt;
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

/// Of a rule that tells the values themselves, "2 or 4 was expected", those.
std::string_view listed_by(const Rule& rule) {
  constexpr std::string_view end = " was expected";
  return rule.words.ends_with(end) ? rule.words.substr(0, rule.words.size() - end.size()) : "";
}

/// "> 0, <= 0.1", "8 .. 64", "2 or 4", "a", "b"; nothing where anything goes.
std::string limits(const Key& key) {
  if (std::holds_alternative<bool*>(key.target)) return "true, false";
  if (const OneOf* choice = std::get_if<OneOf>(&key.target)) {
    std::vector<std::string> words;
    for (const std::string_view word : choice->words) words.push_back(in_quotes(word));
    return fmt::format("{}", fmt::join(words, ", "));
  }
  const Rule& rule = key.rule;
  if (const std::string_view values = listed_by(rule); !values.empty()) return std::string(values);
  const bool below = rule.low > -endless, above = rule.high < endless;
  if (below && above && !rule.above_low && !rule.below_high)
    return fmt::format("{} .. {}", rule.low, rule.high);
  const std::string low = fmt::format("{} {}", rule.above_low ? ">" : ">=", rule.low),
                    high = fmt::format("{} {}", rule.below_high ? "<" : "<=", rule.high);
  return (below ? low : "") + (below && above ? ", " : "") + (above ? high : "");
}

/// And, of a list of tables, those of their keys.
std::string row(std::string_view name, const Key& key) {
  std::string rows = fmt::format("| `{}` | {} | {} | {} | {} |\n", name, usual(key), key.unit,
                                 limits(key), key.says);
  if (const auto* table = std::get_if<InnerTable>(&key.target))
    for (const Key& own : table->keys()) rows += row(fmt::format("{}.{}", name, own.name), own);
  const auto* list = std::get_if<ListOfTables>(&key.target);
  if (!list) return rows;
  list->resize(1);
  for (const Key& own : list->keys(0)) rows += row(fmt::format("{}.{}", name, own.name), own);
  list->resize(0);
  return rows;
}

/// [table], or each of its [[table]].
std::string printed(const SceneTable& table) {
  const std::size_t others = table.others ? table.others->size() : 0;
  const std::string head =
      others ? fmt::format("\n[[{}]]\n", table.name) : fmt::format("\n[{}]\n", table.name);
  std::string text = head + lines(table.keys());
  for (std::size_t k = 0; k < others; ++k) text += head + lines(table.others->keys(k));
  return text;
}

}  // namespace

std::string resolved(const Scene& scene) {
  Scene copy = scene;  // keys are places to write to, too
  std::string text = lines(keys(copy));
  for (const SceneTable& table : tables_that_count(copy))
    if (table.present()) text += printed(table);
  return text;
}

namespace {

/// The values of all keys that count, as text, by their dotted names; that a table is there counts
/// by its name in brackets. Those that can follow from others, as an accuracy chooses the method's
/// own, stand apart.
struct ValuesByName {
  std::vector<std::pair<std::string, std::string>> decided, following;
};

ValuesByName values(Scene scene) {
  constexpr std::array<std::string_view, 3> follows{"flow.nu", "body.panels", "time.dt"};
  ValuesByName all;
  for (const Key& key : keys(scene)) all.decided.emplace_back(key.name, text_of(key).value_or(""));
  const std::size_t of_flow = flow::tables(scene).size();
  std::size_t number = 0;
  for (const SceneTable& table : tables_that_count(scene)) {
    const bool own = number++ >= of_flow;
    if (!table.present()) continue;
    all.decided.emplace_back(fmt::format("[{}]", table.name), "there");
    const auto add = [&](const std::string& number, const Key& key) {
      const std::string name = fmt::format("{}.{}", table.name, key.name);
      const bool apart = own || std::ranges::find(follows, name) != follows.end();
      (apart ? all.following : all.decided)
          .emplace_back(fmt::format("{}{}.{}", table.name, number, key.name),
                        text_of(key).value_or(""));
    };
    for (const Key& key : table.keys()) add("", key);
    for (std::size_t k = 0; table.others && k < table.others->size(); ++k)
      for (const Key& key : table.others->keys(k)) add(fmt::format("[{}]", k + 1), key);
  }
  return all;
}

/// The first name with a value that the other list does not have.
std::string lacking(const auto& one, const auto& other, const auto& left_out) {
  for (const auto& value : one)
    if (!left_out(value.first) && std::ranges::find(other, value) == other.end())
      return value.first;
  return "";
}

}  // namespace

std::string first_difference(const Scene& a, const Scene& b,
                             const std::function<bool(std::string_view name)>& left_out) {
  const ValuesByName one = values(a), other = values(b);
  for (const std::string& name : {lacking(one.decided, other.decided, left_out),
                                  lacking(other.decided, one.decided, left_out),
                                  lacking(one.following, other.following, left_out)})
    if (!name.empty()) return name;
  return lacking(other.following, one.following, left_out);
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
