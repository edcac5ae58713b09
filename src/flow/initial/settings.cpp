#include "flow/initial/settings.hpp"

#include <utility>

#include "tree/base/told.hpp"

namespace vortree::flow {
namespace {

/// "lamb_oseen: a Gaussian vortex; ..."
std::string meanings(InitialFlows known) {
  std::string words;
  for (const InitialFlow* one : known)
    words.append(words.empty() ? "" : "; ").append(one->name).append(": ").append(one->says);
  return words;
}

/// What all kinds have, between the kind and the numbers of its own.
std::vector<Key> common(InitialSettings& initial) {
  return {
      key("circulation", initial.circulation, anything, "L^2/T",
          "of the vortex, which needs it, or of each of two, the left one if they are opposite"),
      key("core", initial.core, positive, "L",
          "width of the vortex, which needs it, or of each of two; of an ellipse half of it "
          "along x; Gaussians are wider than sigma_0"),
      key("spacing", initial.spacing, positive, "sigma_0",
          "distance of the blobs that the vorticity is cut into"),
      key("centre", initial.centre, anything, "L", "place [x, y] of its centre")};
}

}  // namespace

std::vector<Key> keys(InitialSettings& initial, InitialFlows known) {
  std::vector<Key> all = keys_of(as_kinds(known), "kind", "the flow at t = 0; " + meanings(known),
                                 one_of(known, initial.kind), initial.numbers);
  const std::vector<Key> between = common(initial);
  all.insert(all.begin() + 1, between.begin(), between.end());
  all.push_back(
      key("faintest", initial.faintest,
          {.low = 0, .high = 0.1, .above_low = true, .words = "it must lie between 0 and 0.1"}, "",
          "blobs below this share of the strongest are left out"));
  return all;
}

double InitialSettings::number(std::string_view name) const {
  return number_of(*kind, numbers, name);
}

std::optional<PeriodicFlow> periodic_flow(const InitialSettings& initial, double nu) {
  if (!initial.kind->periodic) return std::nullopt;
  return initial.kind->periodic(initial, nu);
}

namespace {

/// Vortices have a circulation and a core, flows that fill the plane have neither.
void hold_vortex(const InitialSettings& initial) {
  for (const auto& [name, value] :
       {std::pair("circulation", initial.circulation), std::pair("core", initial.core)}) {
    const std::string key = std::string("initial.") + name;
    if (!value && !initial.kind->periodic)
      throw Refused("initial", std::string("[initial] needs the key ") + name);
    if (value && initial.kind->periodic)
      throw Refused(key, "initial.kind is \"" + std::string(initial.kind->name) +
                             "\"; that does not have the key " + key);
  }
}

}  // namespace

void refuse(const InitialSettings& initial) {
  hold_vortex(initial);
  hold_dimensions(*initial.kind, "initial", "kind", initial.numbers);
  if (initial.circulation == 0.0)
    throw Refused("initial.circulation",
                  "initial.circulation is 0; there would be no vorticity to follow");
  if (initial.spacing > 3)
    throw Refused("initial.spacing", "initial.spacing is " + tree::told(initial.spacing) +
                                         "; blobs more than 3 cores apart make no vortex; 1 is "
                                         "right");
}

void refuse(const InitialSettings& initial, double sigma_0) {
  initial.kind->hold(initial, sigma_0);
}

}  // namespace vortree::flow
