#include "app/loop/timetable.hpp"

#include <catch2/catch.hpp>

#include "app/program.hpp"
#include "by_vortices.hpp"
#include "flow/warnings.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

const std::string free_vortex = R"(
[flow]
nu = 1e-3
[cores]
sigma_0 = 0.06
sigma_max = 0.07
[initial]
kind = "lamb_oseen"
circulation = 1.0
core = 0.2
[time]
dt = 0.04
end = 0.2
[output]
frames = 0.08
)";

const std::vector<std::string> drawn{"output.window=[-1,-1,1,1]", "output.field_spacing=0.1"};

io::Scene scene(std::vector<std::string> overrides = {}, bool pictures = false) {
  if (pictures) overrides.insert(overrides.end(), drawn.begin(), drawn.end());
  return io::parse_scene(free_vortex, "vortex.toml", by_vortices(), overrides);
}

std::vector<long> frames_of(const io::Scene& scene) {
  const app::Timetable table(scene);
  std::vector<long> steps;
  for (long step = 0; step <= table.last_step(); ++step)
    if (table.frame_due(step)) steps.push_back(step);
  return steps;
}

using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("a run ends at the step nearest to its end, and makes one at least") {
  CHECK(app::Timetable(scene()).last_step() == 5);
  CHECK(app::Timetable(scene({"time.end=0.19"})).last_step() == 5);
  CHECK(app::Timetable(scene({"time.end=0.17"})).last_step() == 4);
  CHECK(app::Timetable(scene({"time.end=0.04"})).last_step() == 1);
}

TEST_CASE(
    "frames are those of the nearest steps, the first and the last; an interval of any length") {
  using Steps = std::vector<long>;
  CHECK(frames_of(scene()) == Steps{0, 2, 4, 5});
  CHECK(frames_of(scene({"output.frames=0.05", "time.end=0.4"})) ==
        Steps{0, 1, 3, 4, 5, 6, 8, 9, 10});
  CHECK(frames_of(scene({"output.frames=1e300"})) == Steps{0, 5});
  CHECK(frames_of(scene({"output.frames=0.04"})) == Steps{0, 1, 2, 3, 4, 5});
}

TEST_CASE("a picture is that of the nearest step, and none beyond the end") {
  const app::Timetable table(scene({"output.fields=[0.05,0.2,1e300]"}, true));
  CHECK(table.field_due(1));
  CHECK(table.field_due(5));
  for (const long step : {0, 2, 3, 4}) CHECK_FALSE(table.field_due(step));
}

TEST_CASE(
    "pictures one after the other: from the start or a time on, beside those that are named") {
  const auto drawn_at = [](std::vector<std::string> overrides) {
    const app::Timetable table(scene(std::move(overrides), true));
    std::vector<long> steps;
    for (long step = 0; step <= table.last_step(); ++step)
      if (table.field_due(step)) steps.push_back(step);
    return steps;
  };
  using Steps = std::vector<long>;
  CHECK(drawn_at({"output.fields_every=0.04"}) == Steps{0, 1, 2, 3, 4, 5});
  CHECK(drawn_at({"output.fields_every=0.08"}) == Steps{0, 2, 4});
  CHECK(drawn_at({"output.fields_every=0.08", "output.fields_from=0.04"}) == Steps{1, 3, 5});
  CHECK(drawn_at({"output.fields_every=0.08", "output.fields=[0.12]"}) == Steps{0, 2, 3, 4});
  CHECK(drawn_at({"output.fields_every=1e-3"}) == Steps{0, 1, 2, 3, 4, 5});
  CHECK(drawn_at({"output.fields_every=0.1", "output.fields_from=1"}).empty());
}

TEST_CASE("pictures one after the other that cannot be are refused, or doubted") {
  CHECK_THROWS_WITH(scene({"output.fields_every=0.04"}), Catch::Contains("needs output.window"));
  CHECK_THROWS_WITH(scene({"output.fields_from=0.04"}, true),
                    Catch::Contains("output.fields_every"));
  CHECK_THROWS_WITH(scene({"output.fields_every=1e-9"}, true), Catch::Contains("2e+08 pictures"));
  CHECK_THROWS_WITH(scene({"output.fields_every=0"}, true), Catch::Contains("must be > 0"));
  CHECK(flow::warnings(scene({"output.fields_every=0.08"}, true)).empty());
  CHECK(flow::warnings(scene({"output.fields_every=0.05", "output.fields_from=0.3"}, true)) ==
        Words{"output.fields_every = 0.05 from 0.3 on meets no multiples of time.dt = 0.04: each "
              "picture is that of the nearest step, up to 0.02 off, and named by its time",
              "output.fields_from = 0.3: beyond the end, t = 0.2; no picture"});
}

TEST_CASE("times that are met raise no doubt; others are named with what comes instead") {
  CHECK(flow::warnings(scene({"output.fields=[0.04,0.2]"}, true)).empty());
  CHECK(flow::warnings(scene({"output.frames=1e9"})).empty());
  CHECK(flow::warnings(scene({"time.end=0.1"})) ==
        Words{"time.end = 0.1 is no multiple of time.dt = 0.04: the run ends at t = 0.12; "
              "time.dt = 0.0333333333 meets it"});
  CHECK(flow::warnings(scene({"output.frames=0.05"})) ==
        Words{"output.frames = 0.05 is no multiple of time.dt = 0.04: each frame is that of the "
              "nearest step, up to 0.02 off"});
  CHECK(flow::warnings(scene({"output.fields=[0.05,0.2,0.3,0.11,7]"}, true)) ==
        Words{"output.fields that are no multiples of time.dt = 0.04 are drawn, and named, at the "
              "nearest step: 0.05 at t = 0.04, 0.11 at t = 0.12",
              "output.fields = 0.3, 7: beyond the end, t = 0.2; no picture"});
}

TEST_CASE("what `check` prints of a chosen step runs to the same bits, and meets its end") {
  const SceneFolder folder("vortex.toml",
                           "accuracy = 0.1\n[flow]\nnu = 1e-3\n[initial]\nkind = \"lamb_oseen\"\n"
                           "circulation = 1\ncore = 0.2\n[time]\nend = 0.5\n");
  CHECK(call("check vortex.toml > printed.toml", folder).code == 0);
  for (const char* name : {"vortex", "printed"}) {
    const auto outcome = call(std::string("run ") + name + ".toml", folder);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
  }
  CHECK(call("check vortex.toml cores.sigma_max=0.08", folder)
            .err.find("accuracy = 0.1 does not rule the error: cores.sigma_max = 0.08 is written, "
                      "and 0.0619 goes with it") != std::string::npos);
  const auto same = shell(
      "for f in vortex printed; do cut -d, -f1-19 runs/$f/report.csv > $f.csv; done;"
      "cmp vortex.csv printed.csv && tail -1 vortex.csv | cut -d, -f1",
      folder);
  CHECK(same.out == "0.5\n");

  // A run that goes on to another end keeps the step that it began with.
  CHECK(call("run vortex.toml --out longer time.end=0.5", folder).code == 0);
  const auto longer = call("run vortex.toml --out longer time.end=0.77 --resume", folder);
  CAPTURE(longer.err);
  CHECK(longer.code == 0);
  CHECK(longer.err.find("time.end = 0.77 is no multiple of time.dt = 0.05") != std::string::npos);
}
