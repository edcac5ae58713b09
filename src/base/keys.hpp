#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

// The keys of a table of settings, as data. Whoever has settings declares them beside the struct
// that holds them, by one function that lists its keys in order:
//
//   std::vector<Key> keys(Merging& merging) {
//     return {key("tolerance", merging.tolerance, not_negative, "L/T", "0: blobs never merge"),
//             key("reach", merging.reach, positive, "cores", "partners are closer than this")};
//   }
//
// What reads, prints, checks and documents settings walks such lists, and knows no key itself.

namespace vortree {

inline constexpr double endless = std::numeric_limits<double>::infinity();

/// Two numbers of one key: a place or a velocity as a scene writes it.
using Pair = std::array<double, 2>;

/// What the numbers of a key must fulfil; `words` say it to the user, after "flow.nu is -1; ".
struct Rule {
  double low = -endless;
  double high = endless;
  bool above_low = false;   ///< low itself is refused
  bool below_high = false;  ///< high itself is refused
  std::string_view words = "";
  bool required = false;  ///< a table without the key is refused
  bool chosen = false;    ///< has no default: what else is written makes it, or it is asked for

  constexpr bool holds(double value) const {
    return (above_low ? value > low : value >= low) && (below_high ? value < high : value <= high);
  }
};

inline constexpr Rule anything{};
inline constexpr Rule positive{.low = 0, .above_low = true, .words = "it must be > 0"};
inline constexpr Rule not_negative{.low = 0, .words = "it must be >= 0"};

constexpr Rule required(Rule rule) {
  rule.required = true;
  return rule;
}

constexpr Rule chosen(Rule rule) {
  rule.chosen = true;
  return rule;
}

/// The words of an enumeration, in the order of its values 0, 1, ...; specialised beside it.
template <class E>
inline constexpr std::array<std::string_view, 0> words_of{};

/// An enumeration whose words are known.
template <class E>
concept Worded = std::is_enum_v<E> && !words_of<E>.empty();

/// The word of a value: "rk2", "boxes", "reverse", ...
template <Worded E>
[[nodiscard]] constexpr std::string_view word(E value) {
  return words_of<E>.at(static_cast<std::size_t>(value));
}

/// A place for one of several words, known by their numbers in the list.
struct OneOf {
  std::vector<std::string_view> words;
  std::function<std::optional<std::size_t>()> get;  ///< none if an optional is not set
  std::function<void(std::size_t)> set;
};

template <Worded E>
[[nodiscard]] OneOf one_of(E& value) {
  return {{words_of<E>.begin(), words_of<E>.end()},
          [&value] { return std::optional(static_cast<std::size_t>(value)); },
          [&value](std::size_t number) { value = static_cast<E>(number); }};
}

template <Worded E>
[[nodiscard]] OneOf one_of(std::optional<E>& value) {
  const auto number = [&value]() -> std::optional<std::size_t> {
    if (!value) return std::nullopt;
    return static_cast<std::size_t>(*value);
  };
  return {{words_of<E>.begin(), words_of<E>.end()}, number, [&value](std::size_t found) {
            value = static_cast<E>(found);
          }};
}

struct Key;

/// A place for tables one after another, `[[sph.region]]`, each with the same keys.
struct ListOfTables {
  std::function<std::size_t()> size;
  std::function<void(std::size_t)> resize;  ///< new ones have their defaults
  std::function<std::vector<Key>(std::size_t number)> keys;
};

/// A place for a table within another, `[body.motion]`, which may be lacking.
struct InnerTable {
  std::function<bool()> present;
  std::function<std::vector<Key>()> keys;  ///< of the table, which is made if it is lacking
};

/// Where the value of a key lives.
using Target = std::variant<bool*, double*, int*, std::int64_t*, std::string*, std::vector<double>*,
                            std::vector<Pair>*, std::array<double, 2>*, std::array<double, 4>*,
                            std::optional<double>*, std::optional<std::string>*,
                            std::optional<std::vector<double>>*,
                            std::optional<std::array<double, 4>>*, OneOf, ListOfTables, InnerTable>;

/// A key of a table. It is good as long as the table that it was made of stays where it is.
///
/// name   as it is written
/// rule   what its numbers must fulfil; of an array, each of them
/// unit   of its numbers, in the table's own length L and time T: "L^2/T", "degrees"; "" for none
/// says   what it is, in one sentence, without a full stop and without "|"
struct Key {
  std::string_view name;
  Target target;
  Rule rule;
  std::string_view unit;
  std::string says;
};

template <class T>
[[nodiscard]] Key key(std::string_view name, T& value, Rule rule, std::string_view unit,
                      std::string says) {
  if constexpr (requires { one_of(value); }) {
    return {name, one_of(value), rule, unit, std::move(says)};
  } else {
    return {name, &value, rule, unit, std::move(says)};
  }
}

/// Tables of settings, whose keys their own function `keys` tells.
template <class Settings>
[[nodiscard]] ListOfTables list_of(std::vector<Settings>& all) {
  return {[&all] { return all.size(); }, [&all](std::size_t n) { all.resize(n); },
          [&all](std::size_t number) { return keys(all[number]); }};
}

template <class Settings>
[[nodiscard]] Key list(std::string_view name, std::vector<Settings>& all, std::string says) {
  return {name, list_of(all), anything, "", std::move(says)};
}

/// A table within another.
template <class Settings>
[[nodiscard]] Key inner(std::string_view name, std::optional<Settings>& settings,
                        std::string says) {
  return {name,
          InnerTable{[&settings] { return settings.has_value(); },
                     [&settings] { return keys(settings ? *settings : settings.emplace()); }},
          anything, "", std::move(says)};
}

/// A word: any of those that its enumeration has.
template <class T>
requires requires(T& value) {
  one_of(value);
}
[[nodiscard]] Key key(std::string_view name, T& value, std::string says) {
  return {name, one_of(value), anything, "", std::move(says)};
}

/// A table of a scene.
///
/// required  a scene without it is refused
/// present   whether the scene has it; only an optional one may be lacking
/// keys      those of the table, which is made, with its defaults, if the scene lacks it
/// others    those after the first, of one that a scene may have several of, `[[body]]`
struct SceneTable {
  std::string_view name;
  bool required;
  std::function<bool()> present;
  std::function<std::vector<Key>()> keys;
  std::optional<ListOfTables> others{};
};

/// A table that is always there, if need be with its defaults.
template <class Settings>
[[nodiscard]] SceneTable table(std::string_view name, Settings& settings, bool required = false) {
  return {name, required, [] { return true; }, [&settings] { return keys(settings); }};
}

/// One that a scene may lack.
template <class Settings>
[[nodiscard]] SceneTable table(std::string_view name, std::optional<Settings>& settings) {
  return {name, false, [&settings] { return settings.has_value(); },
          [&settings] { return keys(settings ? *settings : settings.emplace()); }};
}

/// One that it may lack, or have several of.
template <class Settings>
[[nodiscard]] SceneTable table(std::string_view name, std::optional<Settings>& settings,
                               std::vector<Settings>& others) {
  SceneTable made = table(name, settings);
  made.others = list_of(others);
  return made;
}

/// What a scene says and cannot mean, in words for the user.
///
/// key   to which the words belong: "body.radius", or a table if the key is missing, or "" for the
///       scene as a whole
struct Refused : std::runtime_error {
  Refused(std::string of, const std::string& words)
      : std::runtime_error(words), key(std::move(of)) {}
  std::string key;
};

/// The same of a table that goes by another name: "motion.x is ..." becomes "body[1].motion.x is
/// ...".
[[nodiscard]] inline Refused renamed(const Refused& refused, std::string_view from,
                                     const std::string& to) {
  std::string words = refused.what();
  for (std::size_t at = 0; (at = words.find(from, at)) != std::string::npos;) {
    const std::size_t end = at + from.size();
    const bool apart = at == 0 || !std::isalnum(static_cast<unsigned char>(words[at - 1]));
    const bool named = apart && end < words.size() && (words[end] == '.' || words[end] == ']');
    if (named) words.replace(at, from.size(), to);
    at += named ? to.size() : from.size();
  }
  return {to + refused.key.substr(std::min(from.size(), refused.key.size())), words};
}

}  // namespace vortree
