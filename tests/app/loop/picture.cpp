#include <catch2/catch.hpp>

#include "app/program.hpp"
#include "io/tables/fields.hpp"

using namespace vortree;
using namespace vortree::test;

TEST_CASE("pictures have a pressure, but for that of a body set off at once, and go on with it") {
  const SceneFolder folder("circle.toml", R"(
accuracy = 0.1
[flow]
reynolds = 100
stream = [1.0, 0.0]
[body]
radius = 0.5
[time]
end = 0.2
[output]
frames = 0.1
fields = [0.0, 0.1, 0.2]
window = [-1.0, -0.2, 1.0, 0.2]
field_spacing = 0.1
)");
  REQUIRE(call("run circle.toml time.end=0.1 --out r", folder).code == 0);
  REQUIRE(call("run circle.toml --out whole", folder).code == 0);
  REQUIRE(call("run circle.toml --resume --out r", folder).code == 0);
  const std::vector<double> times = io::field_times(folder / "whole");
  REQUIRE(times.size() == 3);
  CHECK(io::read_field(folder / "whole", times[0]).p.empty());
  for (const double time : {times[1], times[2]}) {
    const io::Field whole = io::read_field(folder / "whole", time);
    REQUIRE(whole.p.size() == whole.u.size());
    CHECK(io::read_field(folder / "r", time) == whole);
    const std::size_t middle = whole.p.size() / 2, ahead = middle - 6;
    CHECK(whole.p[middle] == 0);
    CHECK(whole.p[ahead] > 0.3);
  }
}
