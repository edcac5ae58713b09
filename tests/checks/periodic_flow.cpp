#include <catch2/catch.hpp>

#include "app/methods/methods.hpp"
#include "app/program.hpp"
#include "checks/checks.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

const std::string coarse_vortices = R"(method = "sph"
[flow]
reynolds = 100
[initial]
kind = "taylor_green"
wavelength = 1
[sph]
outside = "periodic"
spacing = 0.125
[time]
end = 0.5
)";

/// The verdict on what is asked, of a report of three rows.
checks::Verdict verdict(const std::string& asked, const std::string& column,
                        const std::vector<double>& values) {
  const TemporaryFolder folder;
  std::string report = "t,T,volume,momentum_x,momentum_y,velocity_error,pressure_error\n";
  for (std::size_t k = 0; k < values.size(); ++k) {
    report += std::to_string(k + 1) + "," + std::to_string(k + 1);
    for (const char* name :
         {"volume", "momentum_x", "momentum_y", "velocity_error", "pressure_error"})
      report += "," + std::to_string(column == name                  ? values[k]
                                     : std::string(name) == "volume" ? 1.0
                                                                     : 0.0);
    report += "\n";
  }
  folder.write("report.csv", report);
  const auto file = folder.write("scene.toml", coarse_vortices);
  const std::vector<std::string> overrides{"check.exact=taylor_green", asked};
  const io::Scene scene = io::parse_scene(coarse_vortices, file, app::methods(), overrides);
  const auto solver = scene.computed_by().begin(scene, 1e9);
  const auto list = checks::verdicts(scene, folder.path(), *solver, flow::scales_of(scene));
  REQUIRE(list.size() == 1);
  return list.front();
}

std::string refused(const std::vector<std::string>& overrides) {
  try {
    (void)io::parse_scene(coarse_vortices, "scene.toml", app::methods(), overrides);
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("errors of vortices of Taylor and Green count at the end") {
  for (const std::string what : {"velocity", "pressure"}) {
    CAPTURE(what);
    const std::string asked = "check." + what + "_rms=0.01", column = what + "_error";
    CHECK(verdict(asked, column, {0.5, 0.02, 0.009}).passed());
    CHECK(verdict(asked, column, {0.001, 0.02, 0.011}).missed());
    CHECK(*verdict(asked, column, {0.5, 0.02, 0.009}).reached.value == 0.009);
  }
}

TEST_CASE("volume and momentum in a periodic box count all the way") {
  CHECK(verdict("check.volume_max=0.01", "volume", {0.995, 1.009, 1}).passed());
  CHECK(verdict("check.volume_max=0.01", "volume", {0.98, 1, 1}).missed());
  CHECK(*verdict("check.volume_max=0.01", "volume", {0.98, 1, 1}).reached.value ==
        Approx(0.02).epsilon(1e-9));
  for (const char* column : {"momentum_x", "momentum_y"}) {
    CHECK(verdict("check.momentum_max=0.01", column, {0.005, -0.009, 0}).passed());
    CHECK(verdict("check.momentum_max=0.01", column, {0.005, -0.02, 0}).missed());
  }
}

TEST_CASE(
    "checks that a flow that fills the plane cannot answer are refused, and its own elsewhere") {
  for (const std::string key : {"circulation_max", "impulse_max", "second_moment_max"})
    CHECK(refused({"check." + key + "=0.1"}) ==
          "command line: check." + key + "=0.1: check." + key +
              " is 0.1; that needs a flow that does not fill the plane");
  CHECK(refused({"check.velocity_rms=0.1"}) ==
        "command line: check.velocity_rms=0.1: check.velocity_rms is 0.1; that needs check.exact = "
        "\"taylor_green\"");
  CHECK(refused({"check.volume_max=0.1"}).empty());
}
