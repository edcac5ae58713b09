#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "app/methods/methods.hpp"
#include "flow/solver.hpp"
#include "io/scene/scene.hpp"

using namespace vortree;

namespace {

const std::string side_by_side = R"(method = "sph"
[flow]
reynolds = 20.0
stream = [1.0, 0.0]
[[body]]
shape = "circle"
radius = 0.5
centre = [0.0, 1.0]
[[body]]
shape = "circle"
radius = 0.5
centre = [0.0, -1.0]
[sph]
spacing = 0.05
box = [-3.0, -4.0, 4.5, 4.0]
[time]
end = 1.5
)";

/// What each body gets along and across the stream from a time on to the end, by the wall.
std::vector<Vec2> given(const std::string& method, const std::vector<std::string>& more,
                        double from) {
  std::vector<std::string> overrides = more;
  overrides.push_back("method=" + method);
  const io::Scene scene =
      io::parse_scene(side_by_side, "cases/side_by_side.toml", app::methods(), overrides);
  const auto solver = scene.computed_by().begin(scene, 1e9);
  std::vector<Vec2> sums(2);
  while (solver->time() < scene.time.end - 1e-9) {
    const auto before = solver->forces_on_each();
    const double t = solver->time();
    solver->step([](auto) {});
    const auto now = solver->forces_on_each();
    if (t < from - 1e-9) continue;
    for (std::size_t k = 0; k < 2; ++k)
      sums[k] +=
          (solver->time() - t) * (now[k].pressure + 0.5 * (before[k].friction + now[k].friction));
  }
  return sums;
}

}  // namespace

TEST_CASE("two circles beside each other feel the same by SPH as by vortices") {
  const auto sph = given("sph", {"time.dt=0.015"}, 0.6),
             vortex = given("vortex", {"accuracy=0.02", "time.dt=0.03"}, 0.6);
  for (const std::size_t k : {0, 1}) {
    CAPTURE(k, sph[k].x, sph[k].y, vortex[k].x, vortex[k].y);
    // Spacing and cores are chosen for 1 to 2 % of the drag at a time; what is given meanwhile is
    // off by a tenth of that, drag and lift alike.
    CHECK(sph[k].x == Approx(vortex[k].x).epsilon(0.01));
    CHECK(std::abs(sph[k].y - vortex[k].y) < 0.005 * vortex[k].x);
    CHECK(std::abs(vortex[k].y) > 0.1 * vortex[k].x);
  }
}
