#include <catch2/catch.hpp>

#include "app/program.hpp"

using namespace vortree::test;

namespace {

const std::string vortex = R"(
accuracy = 0.05
[flow]
nu = 1e-3
[initial]
kind = "lamb_oseen"
circulation = 1.0
core = 0.2
[time]
end = 0.8
[output]
frames = 0.4
fields = [0.0, 0.4, 0.8]
window = [-1.0, -1.0, 1.0, 1.0]
field_spacing = 0.25
)";

/// Runs a line of Python with h5py on the frames of the run in r.
void change_frames(const std::string& line, const TemporaryFolder& folder) {
  const auto done =
      shell("/usr/bin/python3 -c \"import h5py; f = h5py.File('r/frames.h5', 'r+'); " + line + "\"",
            folder);
  CAPTURE(done.err);
  REQUIRE(done.code == 0);
}

/// Replaces what a regular expression finds in the scene that they keep.
void change_scene(const std::string& pattern, const std::string& by,
                  const TemporaryFolder& folder) {
  change_frames(
      "import re; a = f.attrs; t = a['resolved']; t = t if isinstance(t, str) else t.decode(); "
      "a['resolved'] = __import__('numpy').bytes_(re.sub('" +
          pattern + "', '" + by + "', t).encode())",
      folder);
}

const std::string forget_frames = "[f.pop(n) for n in list(f) if n.startswith('frame_')]";

}  // namespace

TEST_CASE("what a run has left before its first frame is replaced, and nothing else") {
  const SceneFolder folder("vortex.toml", vortex);
  REQUIRE(call("run vortex.toml time.end=0.4 --out r", folder).code == 0);
  change_frames(forget_frames, folder);
  const auto refused_for = [&](const std::string& name) {
    const auto outcome = call("run vortex.toml --out r", folder);
    CAPTURE(outcome.err);
    return outcome.code == 2 && outcome.err.find("r/" + name + " is there already") == 9;
  };
  for (const char* name :
       {"report.csv", "energy.csv", "fields.h5", "fields.xdmf", "summary.json"}) {
    CHECK(refused_for(name));
    fs::remove(folder / (std::string("r/") + name));
  }
  CHECK(call("run vortex.toml --out r", folder).code == 0);
}

TEST_CASE("tables of a row and a picture of the start are those of a run without a frame") {
  const SceneFolder folder("vortex.toml", vortex);
  REQUIRE(call("run vortex.toml output.fields=[0] --out r", folder).code == 0);
  change_frames(forget_frames, folder);
  REQUIRE(
      shell("rm r/summary.json; for t in report energy; do sed -i 3,\\$d r/$t.csv; done", folder)
          .code == 0);
  CHECK(call("run vortex.toml --out r", folder).code == 0);
}

TEST_CASE("a frames.h5 that no run has written, or derived files alone, are not replaced") {
  const SceneFolder folder("vortex.toml", vortex);
  fs::create_directory(folder / "r");
  REQUIRE(shell("/usr/bin/python3 -c \"import h5py; h5py.File('r/frames.h5', 'w')['mine'] = 1\"",
                folder)
              .code == 0);
  const auto before = text_of(folder / "r/frames.h5");
  CHECK(call("run vortex.toml --out r", folder).code == 2);
  CHECK(text_of(folder / "r/frames.h5") == before);
  fs::remove(folder / "r/frames.h5");
  for (const char* name : {"r/frames.xdmf", "r/fields.xdmf", "r/outline.csv"}) {
    folder.write(name, "mine");
    CHECK(call("run vortex.toml --out r", folder).code == 2);
    CHECK(text_of(folder / name) == "mine");
    fs::remove(folder / name);
  }
  CHECK(call("run vortex.toml --out r", folder).code == 0);
}

TEST_CASE("a run whose pictures were deleted goes on to its end, and makes those that follow") {
  const SceneFolder folder("vortex.toml", vortex);
  REQUIRE(call("run vortex.toml time.dt=0.05 time.end=0.4 --out r", folder).code == 0);
  fs::remove(folder / "r/fields.h5");
  const auto resumed = call("run vortex.toml time.dt=0.05 --resume --out r", folder);
  CAPTURE(resumed.err);
  CHECK(resumed.code == 0);
  CHECK(resumed.err.find("the pictures of t = 0, 0.4 are lost") != std::string::npos);
  CHECK(fs::exists(folder / "r/fields.h5"));
}

TEST_CASE("frames that are damaged where they tell of their run are named, not the scene") {
  const SceneFolder folder("vortex.toml", vortex);
  REQUIRE(call("run vortex.toml time.end=0.4 --out r", folder).code == 0);
  REQUIRE(
      shell("dd if=/dev/zero of=r/frames.h5 bs=1 seek=96 count=800 conv=notrunc", folder).code ==
      0);
  for (const char* step : {"", "time.dt=0.05"}) {
    const auto resumed = call("run vortex.toml --resume --out r " + std::string(step), folder);
    CAPTURE(resumed.err);
    CHECK(resumed.code == 2);
    CHECK(resumed.err.find("r/frames.h5") != std::string::npos);
    CHECK(resumed.err.find("vortex.toml") == std::string::npos);
  }
}

TEST_CASE("a run of a time when blobs were split into rings goes on with rings, and says so") {
  const SceneFolder folder("vortex.toml", vortex);
  REQUIRE(call("run vortex.toml time.end=0.4 splitting.scheme=ring --out r", folder).code == 0);
  change_scene("\\nscheme = .ring.", "", folder);
  change_frames("del f.attrs['checksum']", folder);
  const auto lattice = call("run vortex.toml --resume --out r", folder);
  CHECK(lattice.code == 2);
  // Cores go with the scheme, and are told first.
  CHECK(lattice.err.find("another [cores] than vortex.toml has now") != std::string::npos);
  const auto rings = call("run vortex.toml splitting.scheme=ring --resume --out r", folder);
  CAPTURE(rings.err);
  CHECK(rings.code == 0);
}

TEST_CASE("a step that is not that of the frames' times is refused, with or without a checksum") {
  const SceneFolder folder("vortex.toml", vortex);
  REQUIRE(call("run vortex.toml time.end=0.4 --out r", folder).code == 0);
  change_scene("\\ndt = [0-9.]+", "\\ndt = 0.0625", folder);
  const auto against_checksum = call("run vortex.toml --resume --out r", folder);
  CHECK(against_checksum.code == 2);
  CHECK(against_checksum.err.find("does not agree with its checksum") != std::string::npos);
  change_frames("del f.attrs['checksum']", folder);
  const auto against_time = call("run vortex.toml --resume --out r", folder);
  CAPTURE(against_time.err);
  CHECK(against_time.code == 2);
  CHECK(against_time.err.find("r/frames.h5: the frame of step") != std::string::npos);
}
