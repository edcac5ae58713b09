#include "vortex/choice/cost.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "by_vortices.hpp"
#include "checks/scenes.hpp"
#include "vortex/setup.hpp"

using namespace vortree;
using namespace vortree::test;
using Catch::Matchers::Contains;

namespace {

vortex::VortexCase scene(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return case_of(io::parse_scene(text, "scene.toml", by_vortices(), overrides));
}

std::string refused_for(double memory, const vortex::VortexCase& asked) {
  try {
    vortex::refuse_beyond(asked, memory);
  } catch (const Refused& error) {
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
      const vortex::VortexCase asked = scene(vortex_by_hand, words);
      const auto made = static_cast<double>(vortex::setup_of(asked).blobs.size());
      CHECK(vortex::cost_of(asked).blobs == Approx(made).epsilon(0.1));
    }
}

TEST_CASE("blobs of a vortex that reaches into the body are not begun with") {
  const auto blobs = [](const char* faintest) {
    return vortex::setup_of(scene(cylinder_by_accuracy,
                                  {"initial.kind=lamb_oseen", "initial.circulation=0.4",
                                   "initial.core=0.5", "initial.centre=[1.5,0.2]", faintest}))
        .blobs;
  };
  const auto within = [](const vortex::Blobs& all) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < all.size(); ++k) count += std::hypot(all.x[k], all.y[k]) <= 0.5;
    return count;
  };
  CHECK(within(blobs("initial.faintest=1e-12")) == 0);
  CHECK(blobs("initial.faintest=1e-12").size() > blobs("initial.faintest=1e-2").size());
}

TEST_CASE("more than the machine holds is refused with the numbers, before anything is made") {
  CHECK(refused_for(1e9, scene(vortex_by_hand)) == "");
  CHECK(refused_for(1e9, scene(cylinder_by_accuracy)) == "");
  CHECK_THAT(refused_for(1e11, scene(vortex_by_hand, {"initial.spacing=1e-6"})),
             Contains("initial.spacing 1e-06 and cores.sigma_0 0.04 cut the vortex") &&
                 Contains("this machine holds 2e+07"));
  CHECK_THAT(refused_for(1e9, scene(cylinder_by_accuracy, {"body.panels=10000"})),
             Contains("body.panels is 10000; the wall's matrix would take 1.6 GB"));
  CHECK_THAT(refused_for(1e11, scene(vortex_by_hand, {"flow.nu=1e10"})),
             Contains("cores.sigma_max 0.05"));
  CHECK_THAT(refused_for(1e11, scene(cylinder_by_accuracy,
                                     {"merging.tolerance=0", "splitting.scheme=ring"})),
             Contains("merging.tolerance 0"));
  CHECK_THAT(
      refused_for(1e9, scene(vortex_by_hand, {"output.fields=[1]", "output.window=[-1,-1,1,1]",
                                              "output.field_spacing=5e-4"})),
      Contains("output.field_spacing 0.0005 makes pictures of 1.6e+07 points"));
}

TEST_CASE("what takes hours, or most of the memory, is warned of") {
  CHECK(vortex::costly(scene(vortex_by_hand), 1e9).empty());
  const auto said = [](const vortex::VortexCase& asked, double memory, const std::string& words) {
    const auto list = vortex::costly(asked, memory);
    return std::ranges::any_of(
        list, [&](const std::string& s) { return s.find(words) != std::string::npos; });
  };
  CHECK(said(scene(vortex_by_hand, {"time.end=1e5"}), 1e9, "the run will take some"));
  CHECK(said(scene(cylinder_by_accuracy, {"flow.reynolds=1e6"}), 1e12, "the run will take some"));
  CHECK(said(scene(cylinder_by_accuracy, {"body.panels=10000"}), 1e10,
             "the wall's matrix takes 1.6 GB"));
  CHECK(said(scene(cylinder_by_accuracy, {"body.panels=20000"}), 1e10, "of the 10 GB there are"));
}
