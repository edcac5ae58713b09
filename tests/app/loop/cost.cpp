#include <catch2/catch.hpp>

#include "app/program.hpp"
#include "checks/scenes.hpp"

using namespace vortree;
using namespace vortree::test;

TEST_CASE("run and check refuse what the machine does not hold, and write nothing") {
  const TemporaryFolder folder;
  folder.write("cylinder.toml", cylinder_by_accuracy);
  for (const char* command : {"run", "check"}) {
    const auto outcome =
        call(std::string(command) + " cylinder.toml body.panels=2147483647", folder);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.err.find("body.panels is 2147483647") != std::string::npos);
  }
  CHECK_FALSE(fs::exists(folder / "runs"));
}

TEST_CASE("a vortex whose blobs multiply ends within a few steps, with its last good frame") {
  const SceneFolder folder("vortex.toml", vortex_by_hand);
  const auto outcome =
      call("run vortex.toml splitting.scheme=ring flow.nu=1 initial.faintest=1e-3", folder);
  CAPTURE(outcome.err);
  CHECK(outcome.code == 1);
  // The count of them or the work of merging them is too much, whichever shows first: the work goes
  // with the lanes of the machine's registers.
  CHECK_THAT(outcome.err, Catch::Contains("they multiply faster than they merge") ||
                              Catch::Contains("crowd in one place"));
  CHECK(outcome.err.find("the last good frame is that of step") != std::string::npos);
}
