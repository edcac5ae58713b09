#pragma once

#include <algorithm>
#include <concepts>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/keys.hpp"

// Things of several kinds that a scene can name, each with keys of its own: shapes of bodies,
// initial flows. A kind is one object in a file of its own, which says what it is called and which
// numbers it has; a list names all kinds. The table that names the kind has the keys of them all.

namespace vortree {

/// A number that a kind has, by the key of that name.
///
/// says       what it is to this kind: "half the long axis"
/// otherwise  what it is where it is not written; without that the kind is refused
struct Dimension {
  std::string_view name;
  Rule rule;
  std::string_view unit, says;
  std::optional<double> otherwise{};

  bool needed() const { return !otherwise; }
};

/// The numbers that a table has for its kind; none where nothing is written.
using Dimensions = std::map<std::string_view, std::optional<double>>;

struct Kind {
  std::string_view name;
  std::vector<Dimension> dimensions;

  /// None if the kind does not have it.
  const Dimension* dimension(std::string_view of) const;
};

using Kinds = std::span<const Kind* const>;

/// Of a list whose kinds are more than that: they as such, and their names.
template <std::derived_from<Kind> Own>
[[nodiscard]] std::vector<const Kind*> as_kinds(std::span<const Own* const> all) {
  return {all.begin(), all.end()};
}
[[nodiscard]] std::vector<std::string_view> names_of(Kinds all);

/// A place for one of a list, by its name; none where it is not listed. The list has to stay where
/// it is.
template <std::derived_from<Kind> Own>
[[nodiscard]] OneOf one_of(std::span<const Own* const> all, const Own*& kind) {
  const auto number = [all, &kind] {
    const auto found = std::ranges::find(all, kind);
    return found == all.end() ? std::nullopt : std::optional<std::size_t>(found - all.begin());
  };
  return {names_of(as_kinds(all)), number, [all, &kind](std::size_t found) { kind = all[found]; }};
}

/// A place for the names of all, none of them set yet.
[[nodiscard]] Dimensions dimensions_of(Kinds all);

/// The keys of a table that names one kind of `all`: a key `name` for the kind, which `get` finds
/// and `set` takes, and one for each number, in the order of the kinds.
[[nodiscard]] std::vector<Key> keys_of(Kinds all, std::string_view name, std::string says,
                                       OneOf kind, Dimensions& numbers);

/// What is written, or what the kind has otherwise.
/// throws  std::invalid_argument if there is neither
[[nodiscard]] double number_of(const Kind& kind, const Dimensions& numbers, std::string_view name);

/// throws  Refused if a number is written that the kind does not have, or lacking that it needs
void hold_dimensions(const Kind& kind, std::string_view table, std::string_view name,
                     const Dimensions& numbers);

}  // namespace vortree
