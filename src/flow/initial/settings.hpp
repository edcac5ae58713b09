#pragma once

#include <array>
#include <vector>

#include "base/keys.hpp"
#include "flow/initial/initial_flow.hpp"

// The table [initial] of a scene.

namespace vortree::flow {

/// The vorticity at t = 0 around `centre`. Vortex blobs that it is cut into lie `spacing` sigma_0
/// apart; those below `faintest` of the strongest are left out. `numbers` are those that the kind
/// has beside circulation and core.
struct InitialSettings {
  const InitialFlow* kind = initial_flows().front();
  double circulation = 1;
  double core = 0;
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

/// throws  Refused if a number lacks that the kind needs, or is there that it does not have;
///         without circulation; with blobs more than three cores apart
void refuse(const InitialSettings& initial);

/// The same once cores are known.
/// throws  Refused if cores of sigma_0 cannot make up a flow of this kind: Gaussians are wider, two
///         vortices between one core and 1e5 of them apart
void refuse(const InitialSettings& initial, double sigma_0);

}  // namespace vortree::flow
