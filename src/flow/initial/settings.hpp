#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/keys.hpp"
#include "flow/initial/initial_flow.hpp"

// The table [initial] of a scene.

namespace vortree::flow {

/// The vorticity at t = 0 around `centre`. Vortex blobs that it is cut into lie `spacing` sigma_0
/// apart; those below `faintest` of the strongest are left out. Circulation and core are those of
/// vortices; `numbers` are what else the kind has.
struct InitialSettings {
  const InitialFlow* kind = initial_flows().front();
  std::optional<double> circulation{};
  std::optional<double> core{};
  double spacing = 1;
  std::array<double, 2> centre{0, 0};
  Dimensions numbers = initial_numbers();
  double faintest = 1e-12;

  /// One of its numbers.
  /// throws  std::invalid_argument if it is not written
  double number(std::string_view name) const;

  bool operator==(const InitialSettings&) const = default;
};

/// Its keys, in the order in which they are read and printed, if these kinds are known.
[[nodiscard]] std::vector<Key> keys(InitialSettings& initial, InitialFlows known = initial_flows());

/// Of a kind that fills the plane, as it is in fluid of viscosity nu; nothing of a vortex.
[[nodiscard]] std::optional<PeriodicFlow> periodic_flow(const InitialSettings& initial, double nu);

/// throws  Refused if a number lacks that the kind needs, or is there that it does not have;
///         without circulation; with blobs more than three cores apart
void refuse(const InitialSettings& initial);

/// The same once cores are known.
/// throws  Refused if cores of sigma_0 cannot make up a flow of this kind: Gaussians are wider, two
///         vortices between one core and 1e5 of them apart
void refuse(const InitialSettings& initial, double sigma_0);

}  // namespace vortree::flow
