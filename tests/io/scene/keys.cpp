#include <array>
#include <set>
#include <sstream>

#include "io/scene/schema.hpp"
#include "scenes.hpp"

using namespace vortree::io;
using namespace vortree::test;
using vortree::Key;
using vortree::OneOf;
using vortree::Rule;

namespace {

enum class Colour { red, green, blue };

/// Every key with its dotted name, of a scene that lives as long as the list.
struct AllKeys {
  Scene scene = blank_scene(by_vortices());
  std::vector<std::pair<std::string, Key>> list;

  AllKeys() {
    for (const Key& key : keys(scene)) list.emplace_back(key.name, key);
    for (const vortree::SceneTable& table : tables(scene))
      for (const Key& key : table.keys())
        list.emplace_back(std::string(table.name) + "." + std::string(key.name), key);
  }
};

/// What is said of a number for a key; nothing if it may be so.
std::string said_of(const std::string& name, const Key& key, double number) {
  const std::string text = plain + "[body]\nradius = 1\n[plunge]\namplitude = 1\nfrequency = 1\n";
  const bool many = std::holds_alternative<std::vector<double>*>(key.target);
  std::ostringstream override;
  override.precision(17);
  override << name << (many ? "=[" : "=") << number << (many ? "]" : "");
  try {
    (void)parse(text, {override.str()});
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

bool refuses(const std::string& name, const Key& key, double number) {
  const std::string said = said_of(name, key, number);
  CAPTURE(name, number, said);
  REQUIRE_FALSE(key.rule.words.empty());
  return said.ends_with("; " + std::string(key.rule.words));
}

/// The numbers that a key has by default.
std::vector<double> defaults(const Key& key) {
  if (const auto* real = std::get_if<double*>(&key.target)) return {**real};
  if (const auto* whole = std::get_if<int*>(&key.target)) return {double(**whole)};
  if (const auto* wide = std::get_if<std::int64_t*>(&key.target)) return {double(**wide)};
  if (const auto* two = std::get_if<std::array<double, 2>*>(&key.target))
    return {(**two)[0], (**two)[1]};
  return {};
}

}  // namespace

template <>
inline constexpr std::array<std::string_view, 3> vortree::words_of<Colour>{"red", "green", "blue"};

TEST_CASE("a key of words reads and writes its enumeration by number, set or not") {
  Colour colour = Colour::green;
  std::optional<Colour> maybe;
  const Key key = vortree::key("colour", colour, "what it looks like");
  const Key open = vortree::key("maybe", maybe, "what it may look like");
  const OneOf& words = std::get<OneOf>(key.target);
  const OneOf& open_words = std::get<OneOf>(open.target);
  CHECK(words.words[*words.get()] == "green");
  words.set(2);
  CHECK(colour == Colour::blue);
  CHECK_FALSE(open_words.get());
  open_words.set(0);
  CHECK(maybe == Colour::red);
  CHECK(open_words.get() == 0u);
  CHECK(vortree::word(Colour::blue) == "blue");
}

TEST_CASE("a key points at the number that it was made of") {
  std::optional<double> number;
  const Key key = vortree::key("number", number, vortree::required(vortree::positive), "L", "one");
  *std::get<std::optional<double>*>(key.target) = 3;
  CHECK(number == 3.0);
  CHECK(key.rule.required);
  CHECK_FALSE(key.rule.holds(0));
}

TEST_CASE("every key says its unit and what it is, in words that fit the cell of a table") {
  const std::set<std::string_view> units{"",    "L",       "T",     "L/T",     "L^2/T",
                                         "1/T", "degrees", "cores", "sigma_0", "chord"};
  for (const auto& [name, key] : AllKeys().list) {
    CAPTURE(name, key.unit, key.says);
    CHECK(units.contains(key.unit));
    CHECK(key.says.size() > 10);
    CHECK(key.says.find_first_of("|\n") == std::string_view::npos);
    CHECK_FALSE(key.says.ends_with("."));
  }
}

TEST_CASE("no key and no table stands twice, and no table has the name of a key") {
  const AllKeys all;
  std::set<std::string> names;
  for (const auto& [name, key] : all.list) {
    CAPTURE(name);
    CHECK(names.insert(name).second);
  }
  Scene scene = blank_scene(by_vortices());
  for (const vortree::SceneTable& table : tables(scene)) {
    CAPTURE(table.name);
    CHECK(names.insert(std::string(table.name)).second);
  }
  CHECK(all.list.size() > 90);
}

TEST_CASE("a default that is printed keeps its own rule") {
  const AllKeys all;
  int kept = 0;
  for (const auto& [name, key] : all.list) {
    if (key.rule.required || key.rule.chosen) continue;
    CAPTURE(name);
    for (const double number : defaults(key)) {
      CHECK(key.rule.holds(number));
      ++kept;
    }
  }
  CHECK(kept > 15);
}

TEST_CASE("a number past either limit of a key is refused in the words of its rule, others not") {
  const AllKeys all;
  int limits = 0;
  for (const auto& [name, key] : all.list) {
    const Rule& rule = key.rule;
    if (rule.low > -vortree::endless) {
      CAPTURE(name, rule.low);
      CHECK(refuses(name, key, rule.low - 1));
      CHECK(refuses(name, key, rule.low) == rule.above_low);
      ++limits;
    }
    if (rule.high < vortree::endless) {
      CAPTURE(name, rule.high);
      CHECK(refuses(name, key, rule.high + 1));
      CHECK(refuses(name, key, rule.high) == rule.below_high);
      ++limits;
    }
  }
  CHECK(limits > 70);
}

TEST_CASE("a table that a scene lacks is made, with its defaults, when its keys are asked for") {
  Scene scene = blank_scene(by_vortices());
  for (const vortree::SceneTable& table : tables(scene)) {
    CAPTURE(table.name);
    const bool lacking = table.name == "body" || table.name == "plunge" || table.name == "motion" ||
                         table.name == "initial";
    CHECK(table.present() != lacking);
    CHECK_FALSE(table.keys().empty());
    CHECK(table.present());
  }
  CHECK(scene.body == vortree::body::BodySettings{});
}
