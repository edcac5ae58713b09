#pragma once

#include <string>
#include <vector>

#include "by_vortices.hpp"
#include "io/sandbox.hpp"
#include "io/scene/scene.hpp"

namespace vortree::test {

// The least that a scene may say.
inline const std::string plain = R"(title = "A vortex"
[flow]
nu = 1e-3

[cores]
sigma_0 = 0.05
sigma_max = 0.1

[initial]
kind = "lamb_oseen"
circulation = 1
core = 0.2

[time]
dt = 0.01
end = 2
)";

// Every table.
inline const std::string full = R"(title = "tab \t, quote \", Gr\u00f6\u00dfe"
seed = 77
[flow]
nu = 0.001
stream = [1, -0.25]
[body]
shape = "circle"
radius = 0.3333333333333333
centre = [0.1, 0.2]
panels = 64
[cores]
sigma_0 = 0.05
sigma_max = 0.1
[splitting]
alpha = 0.8
children = 5
[merging]
tolerance = 0
reach = 1.5
cap = 1.3
[initial]
kind = "lamb_oseen"
circulation = -1.5
core = 0.2
spacing = 0.9
centre = [3, 4]
[time]
dt = 1e-27
end = 5e-20
scheme = "rk4"
[velocity]
method = "direct"
tolerance = 1e-14
order = 13
capacity = 50
finest_level = 0
builder = "forward"
cores = "source"
[output]
frames = 0.125
fields = [0, 0.5, 1e-3]
window = [-1, -2, 3, 4]
field_spacing = 0.1
[check]
lift_max = 0.01
exact = "lamb_oseen"
blobs_max = 100000
)";

// `plain` with some words in place of others.
inline std::string with(const std::string& from, const std::string& to) {
  std::string text = plain;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

inline io::Scene parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return io::parse_scene(text, "cases/ring.toml", by_vortices(), overrides);
}

// Why it is no scene.
inline std::string refused(const std::string& text,
                           const std::vector<std::string>& overrides = {}) {
  return refusal([&] { (void)parse(text, overrides); });
}

}  // namespace vortree::test
