#include <catch2/catch.hpp>

#include "app/program.hpp"
#include "checks/scenes.hpp"

using namespace vortree;
using namespace vortree::test;
using Catch::Matchers::Contains;

namespace {

const std::string body = "run cylinder.toml time.dt=0.1 time.end=0.2 --out run";

/// A run past a body in `run`, without figures, and a scene of a free vortex beside it.
struct AfterRun {
  TemporaryFolder folder;
  NoFigures quick{folder};

  AfterRun() {
    folder.write("cylinder.toml", cylinder_by_accuracy);
    folder.write("vortex.toml", vortex_by_hand);
    REQUIRE(call(body, folder).code == 0);
  }
};

}  // namespace

TEST_CASE("a run that replaces another leaves no table, picture or figure of that one") {
  const AfterRun after;
  const fs::path run = after.folder / "run";
  REQUIRE(fs::exists(run / "wall.csv"));
  const auto outcome =
      call("run vortex.toml time.dt=0.1 time.end=0.2 --out run --overwrite", after.folder);
  CAPTURE(outcome.err);
  CHECK(outcome.code == 0);
  for (const char* name : {"wall.csv", "outline.csv"}) CHECK_FALSE(fs::exists(run / name));
  CHECK(fs::exists(run / "energy.csv"));
}

TEST_CASE("outputs that cannot be written are refused before anything of the older run is lost") {
  const AfterRun after;
  const fs::path run = after.folder / "run";
  const std::string frames = text_of(run / "frames.h5");
  for (const char* name : {"outline.csv", "wall.csv", "report.csv"}) {
    fs::rename(run / name, run / "aside");
    fs::create_symlink("nowhere/x", run / name);
    const auto outcome = call(body + " --overwrite", after.folder);
    CAPTURE(name, outcome.err);
    CHECK(outcome.code == 2);
    CHECK(text_of(run / "frames.h5") == frames);
    fs::remove(run / name);
    fs::rename(run / "aside", run / name);
  }
}

TEST_CASE("two outputs that lead to one file are refused") {
  const AfterRun after;
  const fs::path run = after.folder / "run";
  fs::remove(run / "outline.csv");
  fs::create_symlink("report.csv", run / "outline.csv");
  const std::string report = text_of(run / "report.csv");
  const auto outcome = call(body + " --overwrite", after.folder);
  CHECK(outcome.code == 2);
  CHECK_THAT(outcome.err, Contains("leads to the same file as"));
  CHECK(text_of(run / "report.csv") == report);
}

TEST_CASE("figures that a lost outline keeps from being drawn are told of") {
  const AfterRun after;
  fs::remove(after.folder / "run" / "outline.csv");
  CHECK_THAT(call("plot run", after.folder).err, Contains("run/outline.csv is missing"));
}
