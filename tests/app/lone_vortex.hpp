#pragma once

#include <string>

namespace vortree::test {

/// A scene of a moment: a vortex that neither splits nor merges.
inline const std::string lone_vortex = R"(
[flow]
nu = 1e-3
[cores]
sigma_0 = 0.06
sigma_max = 1
[initial]
kind = "lamb_oseen"
circulation = 1.0
core = 0.2
[merging]
tolerance = 0
[time]
dt = 0.01
end = 0.08
[check]
second_moment_max = 1
)";

/// The same, summed pair by pair.
inline const std::string lone_vortex_by_pairs = lone_vortex + R"([velocity]
method = "direct"
)";

}  // namespace vortree::test
