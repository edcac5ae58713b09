#include <catch2/catch.hpp>
#include <cmath>

#include "app/advice.hpp"
#include "app/program.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

const std::string cylinder = R"(
accuracy = 0.04
[flow]
reynolds = 100
stream = [1.0, 0.0]
[body]
radius = 0.5
[time]
end = 1.0
[output]
frames = 0.5
)";

std::vector<std::string> doubted(const std::vector<std::string>& overrides) {
  return app::doubts(io::parse_scene(cylinder, "cylinder.toml", overrides));
}

bool about(const std::vector<std::string>& doubts, const std::string& key) {
  return std::ranges::any_of(doubts, [&](const std::string& d) { return d.starts_with(key); });
}

}  // namespace

TEST_CASE("settings that an accuracy chose are not doubted, from Re = 20 to 10 000") {
  for (const char* re : {"20", "550", "10000"})
    for (const char* accuracy : {"0.03", "0.01", "0.003"}) {
      const auto doubts =
          doubted({std::string("flow.reynolds=") + re, std::string("accuracy=") + accuracy});
      for (const std::string& doubt : doubts)
        UNSCOPED_INFO(re << ", " << accuracy << ": " << doubt);
      CHECK(doubts.empty());
    }
}

TEST_CASE("ten times too large a step, too wide cores and too few panels are each named") {
  const std::string fine = "accuracy=0.01";
  CHECK(about(doubted({fine, "time.dt=0.4"}), "time.dt = 0.4"));
  CHECK(about(doubted({fine, "cores.sigma_max=0.4"}), "cores.sigma_max = 0.4"));
  CHECK(about(doubted({fine, "time.dt=0.4", "cores.sigma_max=0.04", "cores.sigma_0=0.03"}),
              "cores.sigma_max = 0.04"));
  CHECK(about(doubted({fine, "body.panels=16"}), "body.panels = 16"));
  CHECK(about(doubted({fine, "cores.sigma_0=0.002"}), "cores.sigma_0 = 0.002"));
}

TEST_CASE(
    "a hard run is warned of before it starts, and stays finite or leaves its last good frame") {
  const TemporaryFolder folder;
  setenv("VORTREE_SHARE", folder.path().c_str(), 1);  // no figures
  folder.write("cylinder.toml", cylinder);
  const std::string hard = GENERATE(values<std::string>(
      {"time.dt=0.5 output.frames=0.5", "cores.sigma_max=1.2", "body.panels=12", "time.dt=1e-1"}));
  const auto outcome = call("run cylinder.toml " + hard, folder);
  unsetenv("VORTREE_SHARE");
  CAPTURE(hard, outcome.out, outcome.err);
  if (hard != "time.dt=1e-1")
    CHECK(outcome.err.find("vortree: warning: " + hard.substr(0, hard.find('='))) !=
          std::string::npos);
  else
    CHECK(outcome.err.empty());
  if (outcome.code != 0) {
    CHECK(outcome.code == 1);
    CHECK(outcome.err.find("the last good frame is that of step") != std::string::npos);
  }
  const auto finite = shell(
      "/usr/bin/python3 -c \"import h5py, numpy; f = h5py.File('runs/cylinder/frames.h5');"
      " print(all(numpy.isfinite(f[n]['x'][()]).all() for n in f if n.startswith('frame_')))\"",
      folder);
  CHECK(finite.out == "True\n");
}

TEST_CASE("blobs that multiply end the run before they fill the machine") {
  const TemporaryFolder folder;
  setenv("VORTREE_SHARE", folder.path().c_str(), 1);  // no figures
  folder.write("cylinder.toml", cylinder);
  const auto outcome = call(
      "run cylinder.toml time.dt=0.1 cores.sigma_max=0.03 cores.sigma_0=0.02 time.end=3", folder);
  unsetenv("VORTREE_SHARE");
  CAPTURE(outcome.err);
  CHECK(outcome.code == 1);
  CHECK(outcome.err.find("they multiply faster than they merge") != std::string::npos);
  CHECK(outcome.err.find("the last good frame is that of step") != std::string::npos);
}

TEST_CASE("a run that breaks keeps the state before the step that broke it") {
  const TemporaryFolder folder;
  setenv("VORTREE_SHARE", folder.path().c_str(), 1);  // no figures
  folder.write("cylinder.toml", cylinder);
  // A vortex of a thousand U D beside the body has more vorticity than any such flow.
  const auto outcome = call(
      "run cylinder.toml initial.kind=lamb_oseen initial.circulation=1000 initial.core=0.3 "
      "initial.centre=[3,0] initial.faintest=0.1",
      folder);
  unsetenv("VORTREE_SHARE");
  CAPTURE(outcome.err);
  CHECK(outcome.code == 1);
  CHECK(outcome.err.find("step 1, t = ") != std::string::npos);
  CHECK(outcome.err.find("the last good frame is that of step 0 in") != std::string::npos);
}
