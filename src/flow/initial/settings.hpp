#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "base/keys.hpp"

namespace vortree::flow {

/// The vorticity that a scene can begin with.
enum class InitialKind {
  lamb_oseen,
  gaussian_ellipse,
  kirchhoff_ellipse,
  corotating_pair,
  dipole,
  tripole
};

}  // namespace vortree::flow

namespace vortree {

template <>
inline constexpr std::array<std::string_view, 6> words_of<flow::InitialKind>{
    "lamb_oseen", "gaussian_ellipse", "kirchhoff_ellipse", "corotating_pair", "dipole", "tripole"};

}  // namespace vortree

namespace vortree::flow {

/// The vorticity at t = 0 around `centre`, cut into blobs `spacing` sigma_0 apart; those below
/// `faintest` of the strongest are left out.
///
/// lamb_oseen         a Gaussian vortex of width core > sigma_0
/// gaussian_ellipse   half widths core along x and core_across along y
/// kirchhoff_ellipse  uniform vorticity within half axes core and core_across
/// corotating_pair    two Gaussian vortices, each of `circulation`, `separation` apart along x
/// dipole             the same, of opposite signs; it travels along +y
/// tripole            a Gaussian vortex times 1 + perturbation (x^2 - y^2)/core^2
struct InitialSettings {
  InitialKind kind = InitialKind::lamb_oseen;
  double circulation = 1;
  double core = 0;
  double spacing = 1;
  std::array<double, 2> centre{0, 0};
  std::optional<double> core_across{}, separation{}, perturbation{};
  double faintest = 1e-12;
  bool operator==(const InitialSettings&) const = default;
};

[[nodiscard]] std::vector<Key> keys(InitialSettings&);

}  // namespace vortree::flow
