#pragma once

#include <string>

namespace vortree::test {

/// D = 1, U = 1, T = 2 t; every setting by hand.
inline const std::string cylinder_by_hand = R"(
[flow]
nu = 0.01
stream = [1.0, 0.0]
[body]
radius = 0.5
panels = 16
[cores]
sigma_0 = 0.05
sigma_max = 0.1
[time]
dt = 0.05
end = 10
)";

/// Two of them, one above the other.
inline const std::string pair_by_hand = R"(
[flow]
nu = 0.01
stream = [1.0, 0.0]
[[body]]
radius = 0.5
panels = 16
[[body]]
radius = 0.5
panels = 16
centre = [0.0, 3.0]
[cores]
sigma_0 = 0.05
sigma_max = 0.1
[time]
dt = 0.05
end = 10
)";

/// The same body, Re = 100, its settings chosen.
inline const std::string cylinder_by_accuracy = R"(
accuracy = 0.04
[flow]
reynolds = 100
stream = [1.0, 0.0]
[body]
radius = 0.5
[time]
end = 1.0
)";

inline const std::string vortex_by_hand = R"(
[flow]
nu = 1e-3
[initial]
kind = "lamb_oseen"
circulation = 1.0
core = 0.2
[cores]
sigma_0 = 0.04
sigma_max = 0.05
[time]
dt = 0.02
end = 1.0
)";

}  // namespace vortree::test
