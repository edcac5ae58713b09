#include <catch2/catch.hpp>

#include "app/program.hpp"

using namespace vortree::test;

namespace {

// A vortex that diffuses, splits and merges; frames only at the start and at the end.
const std::string vortex = R"(
[flow]
nu = 1e-3
[cores]
sigma_0 = 0.04
sigma_max = 0.041
[initial]
kind = "lamb_oseen"
circulation = 1.0
core = 0.2
[time]
dt = 0.01
end = 0.1
[output]
frames = 1e9
[check]
circulation_max = 1e-9
)";

// Prints True if two runs wrote the same: all of the last frame, and all of the report but seconds.
const std::string same_run = R"(
import csv, h5py, sys
def rows(folder):
    with open(folder + '/report.csv') as file:
        return [{key: value for key, value in row.items() if 'seconds' not in key}
                for row in csv.DictReader(file)]
def last_frame(folder):
    with h5py.File(folder + '/frames.h5') as file:
        frame = file[max(name for name in file if name.startswith('frame_'))]
        return {name: frame[name][()].tobytes() for name in ('x', 'y', 'gamma', 'sigma', 'u', 'v')}
a, b = sys.argv[1:]
print(len(rows(a)) > 5 and rows(a) == rows(b) and last_frame(a) == last_frame(b))
)";

}  // namespace

TEST_CASE("a run leaves its files, says nothing on a standard error that is no terminal, and 0") {
  const SceneFolder folder("vortex.toml", vortex);
  const auto outcome = call("run vortex.toml flow.nu=2e-3", folder);
  CAPTURE(outcome.out, outcome.err);
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  for (const std::string file : {"report.csv", "frames.h5", "frames.xdmf", "summary.json"})
    CHECK(fs::exists(folder / ("runs/vortex/" + file)));
  CHECK_FALSE(fs::exists(folder / "runs/vortex/outline.csv"));
  CHECK(text_of(folder / "runs/vortex/summary.json").find("\"passed\": true") != std::string::npos);
}

TEST_CASE("a run that misses its check leaves 1") {
  const SceneFolder folder("vortex.toml", vortex);
  const auto outcome = call("run vortex.toml check.blobs_max=2 --out elsewhere", folder);
  CHECK(outcome.code == 1);
  CHECK(text_of(folder / "elsewhere/summary.json").find("\"passed\": false") != std::string::npos);
}

TEST_CASE("a run that is interrupted and resumed ends as one that never was, bit for bit") {
  const SceneFolder folder("vortex.toml", vortex);
  folder.write("same_run.py", same_run);
  const auto stopped =
      interrupted("run vortex.toml time.end=50 --out broken", folder, "broken/report.csv", 8);
  CAPTURE(stopped.err);
  CHECK(stopped.code == 1);
  CHECK(stopped.error_lines() == 1);
  REQUIRE(stopped.err.find("--resume") != std::string::npos);
  const auto step = stopped.err.find("step ") + 5;
  const int last = std::stoi(stopped.err.substr(step)) + 10;
  const std::string end = "time.end=" + std::to_string(last * 0.01);

  const auto resumed = call("run vortex.toml --resume --out broken " + end, folder);
  CAPTURE(resumed.err);
  CHECK(resumed.code == 0);
  CHECK(call("run vortex.toml --out whole " + end, folder).code == 0);
  CHECK(shell("/usr/bin/python3 same_run.py broken whole", folder).out == "True\n");
}

TEST_CASE("the run of a body that plunges, resumed, ends as one that never stopped, bit for bit") {
  const SceneFolder folder("foil.toml", R"(
[flow]
nu = 0.02
stream = [1.0, 0.0]
[body]
shape = "naca0012"
chord = 1.0
panels = 200
[plunge]
amplitude = 0.1
frequency = 1.0
[cores]
sigma_0 = 0.02
sigma_max = 0.1
[merging]
box = [-1.0, -1.0, 0.6, 1.0]
[time]
dt = 0.02
end = 0.4
[velocity]
tolerance = 1e-4
[output]
frames = 1e9
)");
  folder.write("same_run.py", same_run);
  CHECK(call("run foil.toml --out halved time.end=0.2", folder).code == 0);
  const std::string half = text_of(folder / "halved/summary.json");
  CHECK(half.find("\"drifting\": 0.0") == std::string::npos);  // some have left the box
  CHECK(half.find("\"drifting\": ") != std::string::npos);
  CHECK(fs::remove(folder / "halved/outline.csv"));
  const auto resumed = call("run foil.toml --out halved --resume", folder);
  CAPTURE(resumed.err);
  CHECK(resumed.code == 0);
  CHECK(call("run foil.toml --out whole", folder).code == 0);
  CHECK(text_of(folder / "halved/outline.csv") == text_of(folder / "whole/outline.csv"));
  CHECK(shell("/usr/bin/python3 same_run.py halved whole", folder).out == "True\n");
  CHECK(call("run foil.toml --out threads --threads 2", folder).code == 0);
  CHECK(shell("/usr/bin/python3 same_run.py threads whole", folder).out == "True\n");
  CHECK(call("run foil.toml --out halved --resume plunge.amplitude=0.2", folder).code == 2);
}

TEST_CASE("a run that is past its end is not gone on with") {
  const SceneFolder folder("vortex.toml", vortex);
  CHECK(call("run vortex.toml --out past", folder).code == 0);
  const auto outcome = call("run vortex.toml --out past --resume time.end=0.05", folder);
  CHECK(outcome.code == 2);
  CHECK(outcome.err ==
        "vortree: past/frames.h5: the last frame is that of t = 0.1, beyond time.end = 0.05\n");
  CHECK(call("run vortex.toml --out past --resume", folder).code == 0);
}

TEST_CASE("a run that cannot begin is refused with one line and 2") {
  const SceneFolder folder("vortex.toml", vortex);
  const std::string arguments = GENERATE(values<std::string>({
      "--out vortex.toml/below",
      "--out /proc/nowhere",
      "--resume",
      "flow.nu=-1",
      "no.such=1",
  }));
  const auto outcome = call("run vortex.toml " + arguments, folder);
  CAPTURE(arguments, outcome.err);
  CHECK(outcome.code == 2);
  CHECK(outcome.error_lines() == 1);
}

TEST_CASE("where no run has left a frame there is none to go on with, and the line says so") {
  const TemporaryFolder folder;
  folder.write("vortex.toml", vortex);
  fs::create_directory(folder / "killed");
  for (const std::string place : {"killed", "never"}) {
    const auto outcome = call("run vortex.toml --resume --out " + place, folder);
    CHECK(outcome.code == 2);
    CHECK(outcome.err ==
          "vortree: " + place + " holds no run to go on with; without --resume it begins\n");
  }
}

TEST_CASE("a folder for results that is a link to nothing is named, wherever the link stands") {
  const SceneFolder folder("vortex.toml", vortex);
  fs::create_symlink("no/such", folder / "lost");
  fs::create_symlink("loop", folder / "loop");
  fs::create_directory(folder / "r");
  fs::create_symlink("report.csv", folder / "r/report.csv");
  for (const std::string command :
       {"run vortex.toml", "run vortex.toml time.dt=0.02,0.01", "bench velocity"})
    for (const auto& [link, to] : {std::pair("lost", "no/such"), {"loop", "loop"}})
      for (const std::string below : {"", "/below"}) {
        const auto outcome = call(command + " --out " + link + below, folder);
        CAPTURE(command, link, outcome.err);
        CHECK(outcome.code == 2);
        CHECK(outcome.err == std::string("vortree: ") + link + ": is a link to " + to +
                                 ", where nothing is; a folder was expected\n");
      }
  const auto inside = call("run vortex.toml --out r", folder);
  CHECK(inside.code == 2);
  CHECK(inside.err.starts_with("vortree: r/report.csv: "));
  CHECK(fs::is_symlink(folder / "lost"));
  CHECK_FALSE(fs::exists(folder / "no"));
}

TEST_CASE(
    "a picture of a figure's name is replaced by --overwrite only, then drawn as often as asked") {
  const TemporaryFolder folder;
  const NoFigures small(folder);
  fs::create_directory(folder / "plots");
  for (const std::string name : {"cost", "sweep", "velocity_n"})
    folder.write("plots/" + name + ".py", "import sys\nname = sys.argv[1] + '/" + name + ".png'\n" +
                                              "open(name, 'w').write('drawn')\nprint(name)\n");
  folder.write("vortex.toml", vortex);
  fs::create_directory(folder / "r");
  const auto [command, figure] = GENERATE(table<std::string, std::string>(
      {{"run vortex.toml", "r/cost.png"},
       {"run vortex.toml time.dt=0.02,0.01", "r/sweep.png"},
       {"bench velocity --quick --largest 100 --threads 1", "r/velocity_n.png"}}));
  folder.write(figure, "mine");
  const auto refused = call(command + " --out r", folder);
  CAPTURE(command, refused.err);
  CHECK(refused.code == 2);
  CHECK(refused.err.starts_with("vortree: " + figure + " is there already: --overwrite "));
  CHECK(text_of(folder / figure) == "mine");
  CHECK(call(command + " --out r --overwrite", folder).code == 0);
  CHECK(text_of(folder / figure) == "drawn");
  folder.write(figure, "older");
  CHECK(call("plot r", folder).code == 0);
  CHECK(text_of(folder / figure) == "drawn");
}

TEST_CASE("a run in the way is not replaced unasked, by a run or by a sweep") {
  const SceneFolder folder("vortex.toml", vortex);
  REQUIRE(call("run vortex.toml --out r/time.dt=0.02 time.dt=0.02", folder).code == 0);
  const std::string before = text_of(folder / "r/time.dt=0.02/report.csv");
  const std::string again = GENERATE(values<std::string>(
      {"run vortex.toml --out r/time.dt=0.02", "run vortex.toml time.dt=0.02,0.01 --out r"}));
  const auto refused = call(again, folder);
  CAPTURE(again, refused.err);
  CHECK(refused.code == 2);
  CHECK(refused.error_lines() == 1);
  for (const char* word : {"r/time.dt=0.02", "--resume", "--overwrite", "--out"})
    CHECK(refused.err.find(word) != std::string::npos);
  CHECK(text_of(folder / "r/time.dt=0.02/report.csv") == before);
  CHECK_FALSE(fs::exists(folder / "r/time.dt=0.01"));
  CHECK(call(again + " --overwrite", folder).code == 0);
  CHECK(text_of(folder / "r/time.dt=0.02/report.csv") != before);
  CHECK(call(again + " --overwrite --resume", folder).code == 2);
  fs::remove(folder / "r/time.dt=0.02/frames.h5");
  CHECK(call("run vortex.toml --out r/time.dt=0.02", folder).code == 2);
}

TEST_CASE("an output that is an input, no file or has no name is refused, and all stays") {
  const SceneFolder folder("vortex.toml", vortex);
  fs::create_directory(folder / "r");
  fs::create_hard_link(folder / "vortex.toml", folder / "r/summary.json");
  fs::create_directories(folder / "s/report.csv/inside");
  write_particles(folder / "p.h5",
                  {{"x", {0, 1}}, {"y", {0, 1}}, {"gamma", {1, 1}}, {"reach", {1, 1}}});
  fs::create_symlink("p.h5", folder / "link.h5");
  const std::string before = text_of(folder / "p.h5");
  const std::string arguments = GENERATE(values<std::string>({
      "run vortex.toml --overwrite --out r",
      "run vortex.toml --overwrite --out s",
      "run vortex.toml --out ''",
      "run vortex.toml --out p.h5",
      "bench velocity --out ''",
      "velocity p.h5 --out ''",
      "velocity p.h5 --out p.h5",
      "velocity p.h5 --out link.h5",
      "velocity p.h5 --targets link.h5 --out ./p.h5",
      "velocity p.h5 --out /dev/null",
      "neighbors p.h5 --out link.h5",
  }));
  const auto outcome = call(arguments, folder);
  CAPTURE(arguments, outcome.err);
  CHECK(outcome.code == 2);
  CHECK(outcome.error_lines() == 1);
  CHECK(text_of(folder / "p.h5") == before);
  CHECK(text_of(folder / "vortex.toml") == vortex);
  CHECK(fs::exists(folder / "s/report.csv/inside"));
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a result that cannot be printed is a failure, where nothing else holds it") {
  const TemporaryFolder folder;
  CHECK(call("cases >/dev/full", folder).code == 1);
  CHECK(call("cases", folder).code == 0);
}
