#include "base/kinds.hpp"

namespace vortree {

const Dimension* Kind::dimension(std::string_view of) const {
  const auto found = std::ranges::find(dimensions, of, &Dimension::name);
  return found == dimensions.end() ? nullptr : &*found;
}

Dimensions dimensions_of(Kinds all) {
  Dimensions none;
  for (const Kind* kind : all)
    for (const Dimension& one : kind->dimensions) none[one.name];
  return none;
}

namespace {

/// What a number is to each of the kinds that have it.
std::string meanings(Kinds all, std::string_view name) {
  std::string words;
  for (const Kind* kind : all)
    if (const Dimension* one = kind->dimension(name))
      words.append(words.empty() ? "" : "; ")
          .append(kind->name)
          .append(one->needed ? ", which needs it: " : ": ")
          .append(one->says);
  return words;
}

}  // namespace

std::vector<Key> keys_of(Kinds all, std::string_view name, std::string says, OneOf kind,
                         Dimensions& numbers) {
  std::vector<Key> keys{{name, std::move(kind), anything, "", std::move(says)}};
  for (const Kind* one : all)
    for (const Dimension& number : one->dimensions) {
      if (std::ranges::find(keys, number.name, &Key::name) != keys.end()) continue;
      keys.push_back({number.name, &numbers[number.name], number.rule, number.unit,
                      meanings(all, number.name)});
    }
  return keys;
}

void hold_dimensions(const Kind& kind, std::string_view table, std::string_view name,
                     const Dimensions& numbers) {
  for (const auto& [number, value] : numbers) {
    const Dimension* own = kind.dimension(number);
    if (value ? own != nullptr : !(own && own->needed)) continue;
    const std::string in(table), key = in + '.' + std::string(number);
    throw Refused(value ? key : in, in + '.' + std::string(name) + " is \"" +
                                        std::string(kind.name) + "\"; that " +
                                        (value ? "does not have" : "needs") + " the key " + key);
  }
}

}  // namespace vortree
