#include "base/kinds.hpp"

#include <array>
#include <catch2/catch.hpp>

using namespace vortree;

namespace {

/// A sort of kinds that is more than a kind: a solid that rolls down.
struct Solid : Kind {
  double (*volume)(double size) = nullptr;
};

constexpr Rule small{.low = 0, .high = 2, .words = "it must lie in 0 .. 2"};

const Solid ball{{"ball", {{"size", positive, "L", "its radius"}}}};
const Solid barrel{{"barrel",
                    {{"size", positive, "L", "half its height"},
                     {"bulge", small, "", "how round its side is", 0.25}}}};

const std::array<const Solid*, 2> known{&ball, &barrel};
const std::span<const Solid* const> solids(known);

std::string refusal(const Solid& solid, const Dimensions& numbers) {
  try {
    hold_dimensions(solid, "roll", "solid", numbers);
  } catch (const Refused& refused) {
    return refused.key + ": " + refused.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a table that names a kind has a key for its name, and one for each number of any kind") {
  const Solid* solid = known[0];
  Dimensions numbers = dimensions_of(as_kinds(solids));
  CHECK(numbers == Dimensions{{"size", {}}, {"bulge", {}}});
  const std::vector<Key> keys =
      keys_of(as_kinds(solids), "solid", "what rolls", one_of(solids, solid), numbers);
  REQUIRE(keys.size() == 3);
  CHECK((keys[0].name == "solid" && keys[1].name == "size" && keys[2].name == "bulge"));
  CHECK((keys[1].unit == "L" && keys[1].rule.above_low && keys[2].rule.high == 2));
  CHECK(keys[1].says ==
        "ball, which needs it: its radius; barrel, which needs it: half its height");
  CHECK(keys[2].says == "barrel: how round its side is, 0.25 if not written");

  const OneOf kind = std::get<OneOf>(keys[0].target);
  CHECK((kind.words[0] == "ball" && kind.words[1] == "barrel" && kind.get() == 0u));
  kind.set(1);
  CHECK((solid == &barrel && kind.get() == 1u));
  *std::get<std::optional<double>*>(keys[1].target) = 3;
  CHECK(numbers == Dimensions{{"size", 3}, {"bulge", {}}});
}

TEST_CASE("a number is what is written, or the kind's own, or there is none") {
  CHECK(number_of(barrel, {{"size", 3}, {"bulge", {}}}, "bulge") == 0.25);
  CHECK(number_of(barrel, {{"size", 3}}, "bulge") == 0.25);
  CHECK(number_of(barrel, {{"bulge", 1}}, "bulge") == 1);
  CHECK_THROWS_AS(number_of(barrel, {{"size", {}}}, "size"), std::invalid_argument);
  CHECK_THROWS_AS(number_of(ball, {{"size", 1}}, "bulge"), std::invalid_argument);
}

TEST_CASE("a kind is refused with a number that it does not have, and without one that it needs") {
  CHECK(refusal(ball, {{"size", 1}, {"bulge", {}}}).empty());
  CHECK(refusal(barrel, {{"size", 1}}).empty());
  CHECK(refusal(barrel, {{"bulge", 1}}) ==
        "roll: roll.solid is \"barrel\"; that needs the key roll.size");
  CHECK(refusal(barrel, {}) == "roll: roll.solid is \"barrel\"; that needs the key roll.size");
  CHECK(refusal(ball, {{"size", {}}, {"bulge", 1}}) ==
        "roll.bulge: roll.solid is \"ball\"; that does not have the key roll.bulge");
}
