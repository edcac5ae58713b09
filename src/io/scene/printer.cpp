#include <fmt/format.h>
#include <fmt/ranges.h>

#include <concepts>
#include <string>
#include <vector>

#include "io/quote.hpp"
#include "io/scene/scene.hpp"
#include "io/scene/schema.hpp"

namespace vortree::io {
namespace {

using schema::Rule;

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

template <class E>
requires std::is_enum_v<E> std::string toml_text(E value) {
  return fmt::format("\"{}\"", word(value));
}

/// Writes `key = value` lines, a headed paragraph for each table; unset optionals leave no trace.
struct Printer {
  std::string text;

  template <class T>
  void operator()(std::string_view key, const T& value, const Rule&) {
    text += fmt::format("{} = {}\n", key, toml_text(value));
  }

  template <class T>
  void operator()(std::string_view key, const std::optional<T>& value, const Rule& rule) {
    if (value) (*this)(key, *value, rule);
  }

  template <class T>
  void table(std::string_view name, const T& value, bool) {
    text += fmt::format("\n[{}]\n", name);
    schema::walk(value, *this);
  }

  template <class T>
  void table(std::string_view name, const std::optional<T>& value, bool required) {
    if (value) table(name, *value, required);
  }
};

template <class E>
std::string_view word_of(E value) {
  return schema::words_of<E>.at(static_cast<std::size_t>(value));
}

}  // namespace

std::string resolved(const Scene& scene) {
  Printer printer;
  schema::walk(scene, printer);
  return printer.text;
}

std::string_view word(Shape value) {
  return word_of(value);
}
std::string_view word(InitialKind value) {
  return word_of(value);
}
std::string_view word(DiffusionKind value) {
  return word_of(value);
}
std::string_view word(TimeScheme value) {
  return word_of(value);
}
std::string_view word(VelocityMethod value) {
  return word_of(value);
}
std::string_view word(TreeBuilder value) {
  return word_of(value);
}
std::string_view word(PairCores value) {
  return word_of(value);
}
std::string_view word(ExactAnswer value) {
  return word_of(value);
}

}  // namespace vortree::io
