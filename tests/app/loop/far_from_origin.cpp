#include <catch2/catch.hpp>
#include <cmath>

#include "app/program.hpp"
#include "io/frames/read.hpp"
#include "io/tables/table.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

const std::string free_vortex = R"(
[flow]
nu = 1e-3
[initial]
kind = "gaussian_ellipse"
circulation = 1.0
core = 0.2
core_across = 0.15
[cores]
sigma_0 = 0.04
sigma_max = 0.05
[merging]
tolerance = 5e-3
[time]
dt = 0.03125
end = 0.5
)";

const std::string cylinder = R"(
accuracy = 0.05
[flow]
reynolds = 100
stream = [1.0, 0.0]
[body]
radius = 0.5
[time]
end = 0.5
)";

io::Table report_of(const TemporaryFolder& folder, const std::string& arguments) {
  const NoFigures quick(folder);
  const auto outcome = call("run " + arguments, folder);
  CAPTURE(arguments, outcome.err);
  REQUIRE(outcome.code == 0);
  const std::string out = arguments.substr(arguments.find("--out ") + 6);
  return io::Table(folder / out / "report.csv");
}

/// All that a report says but for seconds, and for what depends on where the origin is.
void check_same(const io::Table& here, const io::Table& there) {
  for (const std::string name :
       {"t", "T", "blobs", "circulation", "second_moment", "cd_impulse", "cd_wall", "cl_impulse",
        "cl_wall", "bubble_length", "separation_deg", "quadrupole_xx", "quadrupole_xy",
        "separation", "circulation_plus"}) {
    CAPTURE(name);
    CHECK(here.column(name) == there.column(name));
  }
}

}  // namespace

TEST_CASE("a free vortex is the same to the last bit wherever it lies, and in any stream") {
  const TemporaryFolder folder;
  folder.write("vortex.toml", free_vortex);
  const io::Table here = report_of(folder, "vortex.toml --out here");
  for (const std::string where :
       {"initial.centre=[1e6,-2e6]", "initial.centre=[1e9,1e9]", "initial.centre=[0,1e15]",
        "flow.stream=[3,0.5]", "flow.stream=[1e7,0]"}) {
    const io::Table there = report_of(folder, "vortex.toml " + where + " --out there");
    CAPTURE(where);
    check_same(here, there);
    fs::remove_all(folder / "there");
  }
}

TEST_CASE("a vortex's impulse, centre and blobs are written as seen from the scene's origin") {
  const TemporaryFolder folder;
  folder.write("vortex.toml", free_vortex);
  const io::Table here = report_of(folder, "vortex.toml --out here");
  // Round numbers in binary: sums with them are exact to the last digits that they leave.
  const io::Table there =
      report_of(folder, "vortex.toml initial.centre=[1024,0] flow.stream=[0,16] --out there");
  const auto t = here.column("t");
  for (std::size_t r = 0; r < t.size(); ++r) {
    CHECK(there.column("plus_x")[r] - 1024 == Approx(here.column("plus_x")[r]).margin(1e-12));
    CHECK(there.column("plus_y")[r] == Approx(16 * t[r] + here.column("plus_y")[r]).margin(1e-12));
    CHECK(there.column("impulse_x")[r] == Approx(16 * t[r]).margin(1e-9));
    CHECK(there.column("impulse_y")[r] == Approx(-1024).margin(1e-9));
  }
  const auto last = [&](const char* run) {
    return *io::read_last_good(folder / run / "frames.h5").last;
  };
  const io::Frame a = last("here"), b = last("there");
  REQUIRE(a.particles() == b.particles());
  for (const auto& [name, more] : {std::pair{"x", 1024.0}, std::pair{"y", 16 * b.time},
                                   std::pair{"u", 0.0}, std::pair{"v", 16.0}})
    for (std::size_t i = 0; i < a.particles(); ++i)
      CHECK(flow::column(b.columns, name)[i] == flow::column(a.columns, name)[i] + more);
}

TEST_CASE("a body has the same forces to the last bit wherever it lies") {
  const TemporaryFolder folder;
  folder.write("cylinder.toml", cylinder);
  const std::string box = " merging.box=[-2,-2,0.75,2]";
  const io::Table here = report_of(folder, "cylinder.toml" + box + " --out here");
  const io::Table there = report_of(
      folder,
      "cylinder.toml body.centre=[1024,-2048] merging.box=[1022,-2050,1024.75,-2046] --out "
      "there");
  check_same(here, there);
  CHECK(here.column("impulse_x") == there.column("impulse_x"));
  CHECK(here.column("impulse_y") == there.column("impulse_y"));
  CHECK(text_of(folder / "here/wall.csv") == text_of(folder / "there/wall.csv"));
}

TEST_CASE("a run far from the origin, stopped on its way, goes on to the same report") {
  const TemporaryFolder folder;
  folder.write("vortex.toml", free_vortex);
  const std::string far = "vortex.toml initial.centre=[1e9,0.1] flow.stream=[0.3,0] ";
  const io::Table whole = report_of(folder, far + "--out whole");
  const io::Table half = report_of(folder, far + "time.end=0.25 --out half");
  const io::Table rest = report_of(folder, far + "--resume --out half");
  for (const std::string name : {"blobs", "impulse_x", "impulse_y", "second_moment", "plus_x"})
    CHECK(whole.column(name) == rest.column(name));
}
