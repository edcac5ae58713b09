#include "checks/warnings/cost.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "app/methods/methods.hpp"
#include "app/methods/vortex.hpp"
#include "app/program.hpp"
#include "checks/scenes.hpp"

using namespace vortree;
using namespace vortree::test;
using Catch::Matchers::Contains;

namespace {

io::Scene scene(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return io::parse_scene(text, "scene.toml", overrides);
}

std::string refused_for(double memory, const io::Scene& asked) {
  try {
    checks::refuse_beyond(asked, memory);
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the estimate of a vortex's blobs is that of its lattice, to a few rows around it") {
  for (const char* spacing : {"initial.spacing=1", "initial.spacing=0.5"})
    for (const char* kind : {"lamb_oseen", "dipole initial.separation=2"}) {
      std::vector<std::string> words{spacing, "flow.nu=0"};
      std::istringstream pairs("initial.kind=" + std::string(kind));
      for (std::string word; pairs >> word;) words.push_back(word);
      const io::Scene asked = scene(vortex_by_hand, words);
      const auto made =
          static_cast<double>(app::vortex_setup(asked, app::scales_of(asked)).blobs.size());
      CHECK(checks::cost_of(asked).blobs == Approx(made).epsilon(0.1));
    }
}

TEST_CASE("more than the machine holds is refused with the numbers, before anything is made") {
  CHECK(refused_for(1e9, scene(vortex_by_hand)) == "");
  CHECK(refused_for(1e9, scene(cylinder_by_accuracy)) == "");
  CHECK_THAT(refused_for(1e11, scene(vortex_by_hand, {"initial.spacing=1e-6"})),
             Contains("scene.toml: initial.spacing 1e-06 and cores.sigma_0 0.04 cut the vortex") &&
                 Contains("this machine holds 2e+07"));
  CHECK_THAT(refused_for(1e9, scene(cylinder_by_accuracy, {"body.panels=10000"})),
             Contains("body.panels is 10000; the wall's matrix would take 1.6 GB"));
  CHECK_THAT(refused_for(1e11, scene(vortex_by_hand, {"flow.nu=1e10"})),
             Contains("cores.sigma_max 0.05"));
  CHECK_THAT(refused_for(1e11, scene(cylinder_by_accuracy, {"merging.tolerance=0"})),
             Contains("merging.tolerance 0"));
  CHECK_THAT(
      refused_for(1e9, scene(vortex_by_hand, {"output.fields=[1]", "output.window=[-1,-1,1,1]",
                                              "output.field_spacing=5e-4"})),
      Contains("output.field_spacing 0.0005 makes pictures of 1.6e+07 points"));
}

TEST_CASE("what takes hours, or most of the memory, is warned of") {
  CHECK(checks::costly(scene(vortex_by_hand), 1e9).empty());
  const auto said = [](const io::Scene& asked, double memory, const std::string& words) {
    const auto list = checks::costly(asked, memory);
    return std::ranges::any_of(
        list, [&](const std::string& s) { return s.find(words) != std::string::npos; });
  };
  CHECK(said(scene(vortex_by_hand, {"time.end=1e5"}), 1e9, "the run will take some"));
  CHECK(said(scene(cylinder_by_accuracy, {"flow.reynolds=1e6"}), 1e12, "the run will take some"));
  CHECK(said(scene(cylinder_by_accuracy, {"body.panels=10000"}), 1e10,
             "the wall's matrix takes 1.6 GB"));
  CHECK(said(scene(cylinder_by_accuracy, {"body.panels=20000"}), 1e10, "of the 10 GB there are"));
}

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
  const TemporaryFolder folder;
  const NoFigures quick(folder);
  folder.write("vortex.toml", vortex_by_hand);
  const auto outcome = call("run vortex.toml flow.nu=1 initial.faintest=1e-3", folder);
  CAPTURE(outcome.err);
  CHECK(outcome.code == 1);
  // The count of them or the work of merging them is too much, whichever shows first: the work goes
  // with the lanes of the machine's registers.
  CHECK_THAT(outcome.err, Catch::Contains("they multiply faster than they merge") ||
                              Catch::Contains("crowd in one place"));
  CHECK(outcome.err.find("the last good frame is that of step") != std::string::npos);
}
