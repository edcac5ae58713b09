#include "base/kinds.hpp"

#include "base/rounded.hpp"

namespace vortree {

const Dimension* Kind::dimension(std::string_view of) const {
  const auto found = std::ranges::find(dimensions, of, &Dimension::name);
  return found == dimensions.end() ? nullptr : &*found;
}

std::vector<std::string_view> names_of(Kinds all) {
  std::vector<std::string_view> names;
  for (const Kind* kind : all) names.push_back(kind->name);
  return names;
}

Dimensions dimensions_of(Kinds all) {
  Dimensions none;
  for (const Kind* kind : all)
    for (const Dimension& one : kind->dimensions) none[one.name];
  return none;
}

namespace {

/// "circle, which needs it: its radius"
std::string meaning(const Kind& kind, const Dimension& number) {
  std::string words(kind.name);
  words.append(number.needed() ? ", which needs it: " : ": ").append(number.says);
  if (number.otherwise) words.append(", " + rounded(*number.otherwise, 6) + " if not written");
  return words;
}

/// What a number is to each of the kinds that have it.
std::string meanings(Kinds all, std::string_view name) {
  std::string words;
  for (const Kind* kind : all)
    if (const Dimension* one = kind->dimension(name))
      words.append(words.empty() ? "" : "; ").append(meaning(*kind, *one));
  return words;
}

std::optional<double> written(const Dimensions& numbers, std::string_view name) {
  const auto found = numbers.find(name);
  return found == numbers.end() ? std::nullopt : found->second;
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

double number_of(const Kind& kind, const Dimensions& numbers, std::string_view name) {
  if (const auto value = written(numbers, name)) return *value;
  const Dimension* own = kind.dimension(name);
  if (!own || own->needed())
    throw std::invalid_argument("no number " + std::string(name) + " of " + std::string(kind.name));
  return *own->otherwise;
}

void hold_dimensions(const Kind& kind, std::string_view table, std::string_view name,
                     const Dimensions& numbers) {
  const std::string in(table);
  const auto words = [&](const std::string& that, std::string_view number) {
    return in + '.' + std::string(name) + " is \"" + std::string(kind.name) + "\"; that " + that +
           " the key " + in + '.' + std::string(number);
  };
  for (const auto& [number, value] : numbers)
    if (value && !kind.dimension(number))
      throw Refused(in + '.' + std::string(number), words("does not have", number));
  for (const Dimension& own : kind.dimensions)
    if (own.needed() && !written(numbers, own.name)) throw Refused(in, words("needs", own.name));
}

}  // namespace vortree
