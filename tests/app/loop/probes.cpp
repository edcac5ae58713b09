#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "app/methods/methods.hpp"
#include "app/program.hpp"
#include "io/input_error.hpp"
#include "io/scene/scene.hpp"
#include "io/tables/table.hpp"

using namespace vortree;
using namespace vortree::test;
using Catch::Contains;

namespace {

const std::string vortex = R"(
accuracy = 0.02
[flow]
nu = 1e-3
[initial]
kind = "lamb_oseen"
circulation = 1.0
core = 0.2
[time]
dt = 0.05
end = 0.5
[output]
frames = 0.25
[[probe]]
points = [[0.3, 0.0], [0.1, -0.2]]
[[probe]]
line = [-0.4, 0.1, 0.4, 0.1]
count = 5
every = 0.1
)";

const std::string circle = R"(
accuracy = 0.1
[flow]
reynolds = 100
stream = [1.0, 0.0]
[body]
radius = 0.5
[time]
end = 0.1
[output]
frames = 0.1
[[probe]]
points = [[0.1, 0.2], [-3.0, 0.0], [0.0, 1.0]]
)";

std::string refused(const std::string& probe) {
  const std::string text = vortex.substr(0, vortex.find("[[probe]]"));
  try {
    (void)io::parse_scene(text + probe, "cases/vortex.toml", app::methods(), {});
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("probes tell velocity and vorticity of the flow at their places, step by step") {
  const SceneFolder folder("vortex.toml", vortex);
  REQUIRE(call("run vortex.toml --out r", folder).code == 0);
  const io::Table table(folder / "r/probes.csv");
  const auto t = table.column("t"), probe = table.column("probe"), x = table.column("x"),
             y = table.column("y"), u = table.column("u"), v = table.column("v"),
             omega = table.column("omega");
  REQUIRE(t.size() == 11 * 2 + 6 * 5);
  CHECK(probe.front() == 1);
  CHECK(std::ranges::count(probe, 2.0) == 6 * 5);
  CHECK(t.back() == Approx(0.5));
  CHECK(x.back() == Approx(0.4));
  CHECK(x[3] == Approx(-0.2));
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double r2 = x[k] * x[k] + y[k] * y[k], core = 0.2 * 0.2 + 4e-3 * t[k];
    const double swirl = (1 - std::exp(-r2 / core)) / (2 * std::numbers::pi * r2);
    CAPTURE(t[k], x[k], y[k]);
    CHECK(u[k] == Approx(-swirl * y[k]).margin(0.01));
    CHECK(v[k] == Approx(swirl * x[k]).margin(0.01));
    CHECK(omega[k] == Approx(std::exp(-r2 / core) / (std::numbers::pi * core)).margin(0.1));
  }
}

TEST_CASE("a resumed run ends with the same probes, of rows that were lost, too") {
  const SceneFolder folder("vortex.toml", vortex);
  REQUIRE(call("run vortex.toml --out whole", folder).code == 0);
  REQUIRE(call("run vortex.toml time.end=0.25 --out parts", folder).code == 0);
  REQUIRE(shell("tail -n 3 parts/probes.csv >> parts/probes.csv", folder).code == 0);
  REQUIRE(call("run vortex.toml --out parts --resume", folder).code == 0);
  const std::string whole = text_of(folder / "whole/probes.csv");
  CHECK(text_of(folder / "parts/probes.csv") == whole);
  REQUIRE(call("run vortex.toml time.end=0.25 --out parts --overwrite", folder).code == 0);
  REQUIRE(shell("rm parts/probes.csv", folder).code == 0);
  REQUIRE(call("run vortex.toml --out parts --resume", folder).code == 0);
  CHECK(text_of(folder / "parts/probes.csv") == whole);
  const Outcome other = call(
      "run vortex.toml 'probe=[{points=[[1, 1]]}]' time.end=0.6 --out parts "
      "--resume",
      folder);
  CHECK(other.code == 2);
  CHECK_THAT(other.err, Contains("was run with another probe"));
  CHECK(call("run vortex.toml 'probe=[]' --out parts --overwrite", folder).code == 0);
  CHECK_FALSE(fs::exists(folder / "parts/probes.csv"));
}

TEST_CASE("probes alone are not replaced, those of a start without a frame are") {
  const SceneFolder folder("vortex.toml", vortex);
  REQUIRE(shell("mkdir r && printf 't,probe\\n0,1\\n' > r/probes.csv", folder).code == 0);
  const Outcome outcome = call("run vortex.toml --out r", folder);
  CHECK(outcome.code == 2);
  CHECK_THAT(outcome.err, Contains("r/probes.csv is there already"));
  CHECK(call("run vortex.toml --out r --overwrite", folder).code == 0);
}

TEST_CASE("a probe within a body tells nothing moves there, one upstream the stream") {
  const SceneFolder folder("circle.toml", circle);
  REQUIRE(call("run circle.toml --out r", folder).code == 0);
  const io::Table table(folder / "r/probes.csv");
  const auto u = table.column("u"), v = table.column("v"), omega = table.column("omega");
  REQUIRE(u.size() >= 6);
  for (std::size_t k = 0; k < u.size(); k += 3) {
    CHECK((u[k] == 0 && v[k] == 0 && omega[k] == 0));
    CHECK(u[k + 1] == Approx(1 - 0.25 / 9).epsilon(0.01));  // potential flow
    CHECK(u[k + 2] == Approx(1.25).epsilon(0.03));
  }
}

TEST_CASE("probes that cannot be meant are refused with their number and the reason") {
  const std::string place = "cases/vortex.toml:14: ";
  CHECK(refused("[[probe]]\n") == place + "probe[0] needs either points or a line");
  CHECK(refused("[[probe]]\npoints = [[0, 0]]\nline = [0, 0, 1, 1]\n") ==
        place + "probe[0] needs either points or a line");
  CHECK(refused("[[probe]]\nline = [0, 0, 1, 1]\ncount = 1\n") ==
        place + "probe[0].count is 1; a line has 2 places or more");
  CHECK(refused("[[probe]]\npoints = [[0, 0]]\ncount = 3\n") ==
        place + "probe[0].count needs a line beside it");
  CHECK(refused("[[probe]]\npoints = [[0, 0]]\nevery = 0.01\n") ==
        place + "probe[0].every is 0.01; it must be >= time.dt = 0.05");
  CHECK(refused("[[probe]]\npoints = [[0, 0], [1]]\n") ==
        "cases/vortex.toml:15: probe[0].points[1] has 1 elements; an array of 2 numbers was "
        "expected");
  CHECK(refused("[[probe]]\npoints = 3\n") ==
        "cases/vortex.toml:15: probe[0].points is an integer; an array of arrays of 2 numbers was "
        "expected");
  CHECK_THAT(refused("[[probe]]\nline = [0, 0, 1, 1]\ncount = 2000000\n"),
             Contains("probe has 2e+06 places; 1e+06 at most are told"));
}

TEST_CASE("probes are printed so that they read back to themselves") {
  const io::Scene scene = io::parse_scene(vortex, "cases/vortex.toml", app::methods(), {});
  const io::Scene again =
      io::parse_scene(io::resolved(scene), "cases/vortex.toml", app::methods(), {});
  CHECK(again.probes == scene.probes);
  REQUIRE(scene.probes.size() == 2);
  CHECK(scene.probes[0] == flow::ProbeSettings{{{0.3, 0}, {0.1, -0.2}}, {}, 0, {}});
  const auto places = scene.probes[1].places();
  REQUIRE(places.size() == 5);
  for (std::size_t k = 0; k < 5; ++k) {
    CHECK(places[k][0] == Approx(-0.4 + 0.2 * static_cast<double>(k)).margin(1e-15));
    CHECK(places[k][1] == Approx(0.1));
  }
  CHECK(places.front()[0] == -0.4);
  CHECK(places.back()[0] == 0.4);
}
