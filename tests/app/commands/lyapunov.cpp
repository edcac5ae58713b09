#include <catch2/catch.hpp>

#include "app/program.hpp"

using namespace vortree::test;

namespace {

const std::string vortex = R"(
accuracy = 0.02
[flow]
nu = 1e-3
[initial]
kind = "lamb_oseen"
circulation = 1.0
core = 0.2
[time]
end = 0.8
[output]
frames = 0.8
fields_every = 0.1
window = [-0.6, -0.6, 0.6, 0.6]
field_spacing = 0.02
)";

const std::string plunging = R"(
accuracy = 0.1
[flow]
reynolds = 40
[body]
shape = "circle"
radius = 0.5
[plunge]
amplitude = 0.4
frequency = 0.4
[time]
end = 0.6
[output]
frames = 0.6
fields_every = 0.05
fields_from = 0.2
window = [-1.2, -1.2, 1.2, 1.2]
field_spacing = 0.06
)";

/// The exponent of a Lamb-Oseen vortex is known: fluid at r is sheared by s = r d/dr of the angle
/// by which it turns, and the stretch of a shear s is s/2 + sqrt(1 + s^2/4).
const std::string compare = R"(
import h5py, numpy as np
with h5py.File('r/lyapunov.h5') as file:
    group = file['lyapunov_' + BEGIN]
    x, y, found = group['x'][()], group['y'][()], group[WAY][()]
    assert group.attrs[WAY + '_to'] == END, group.attrs[WAY + '_to']
    for name in ('version', 'resolved', 'machine', 'compiler', 'commit', 'date'):
        assert len(file.attrs[name]) > 0
r = np.hypot(*np.meshgrid(x, y))
t = np.linspace(0, 0.8, 401)
def angle(r):
    core = 0.04 + 4e-3 * t[:, None]
    return np.trapz((1 - np.exp(-r**2 / core)) / (2 * np.pi * r**2), t, axis=0)
at = np.linspace(0.02, 0.7, 2001)
s = np.abs(at * np.gradient(angle(at), at))
exact = np.interp(r, at, np.log(s / 2 + np.sqrt(1 + s**2 / 4)) / 0.8)
ring = (r > 0.05) & (r < 0.5)
assert np.isfinite(found[ring]).all()
print(np.abs(found - exact)[ring].max(), exact[ring].max())
)";

void python(const std::string& script, const TemporaryFolder& in, std::string& told) {
  in.write("script.py", script);
  const Outcome done = shell("/usr/bin/python3 script.py", in);
  CAPTURE(done.err);
  REQUIRE(done.code == 0);
  told = done.out;
}

}  // namespace

TEST_CASE("the exponents of a vortex by its pictures are those that its shear makes") {
  const SceneFolder folder("vortex.toml", vortex);
  REQUIRE(call("run vortex.toml --out r", folder).code == 0);
  const auto done = call("lyapunov r --from 0.8 0 --to 0 0.8", folder);
  CAPTURE(done.out, done.err);
  REQUIRE(done.code == 0);
  CHECK(done.out.find("t = 0.8 back to 0: 3721 tracers") != std::string::npos);
  CHECK(done.out.find("t = 0 forward to 0.8: 3721 tracers") != std::string::npos);
  struct Row {
    std::string begin, way, end;
  };
  for (const auto& [begin, way, end] : {Row{"0.8", "backward", "0"}, Row{"0", "forward", "0.8"}}) {
    std::string told;
    python("BEGIN, WAY, END = '" + begin + "', '" + way + "', " + end + compare, folder, told);
    double error = 0, most = 0;
    std::istringstream(told) >> error >> most;
    CAPTURE(way, error, most);
    CHECK(most > 1);
    // The accuracy asked for is of velocities, 0.02; shears are their slopes.
    CHECK(error < 0.05 * most);
  }
}

TEST_CASE("exponents are the same bits by one thread and two, and nothing of a body is known") {
  const SceneFolder folder("plunging.toml", plunging);
  const std::string method = GENERATE("vortex", "sph");
  REQUIRE(call("run plunging.toml --out r method=" + method, folder).code == 0);
  for (const char* threads : {"1", "2"}) {
    const auto done = call(
        "lyapunov r --from 0.6 --to 0.3 --spacing 0.05 --threads " + std::string(threads), folder);
    CAPTURE(done.err);
    REQUIRE(done.code == 0);
    fs::rename(folder / "r/lyapunov.h5", folder / (std::string(threads) + ".h5"));
  }
  std::string told;
  python(R"(
import h5py, numpy as np
files = [h5py.File(n + '.h5') for n in '12']
one, two = (file[list(file)[0]] for file in files)
assert abs(one.attrs['time'] - 0.6) < 1e-9 and abs(one.attrs['backward_to'] - 0.3) < 1e-9
assert one['backward'][()].tobytes() == two['backward'][()].tobytes()
r = np.hypot(*np.meshgrid(one['x'][()], one['y'][()]))
known = np.isfinite(one['backward'][()])
print(known[r < 0.5].sum(), known[(r > 0.51) & (r < 0.7)].mean(), known.mean())
)",
         folder, told);
  double inside = 1, beside = 0, share = 0;
  std::istringstream(told) >> inside >> beside >> share;
  CHECK(inside == 0);
  CHECK(beside == 1);  // tracers beside the wall stick to it, and do not enter
  CHECK(share > 0.3);
}

TEST_CASE("a folder, or times, of which nothing can be told are refused in one line") {
  const SceneFolder folder("vortex.toml", vortex);
  fs::create_directory(folder / "empty");
  REQUIRE(call("run vortex.toml --out r", folder).code == 0);
  REQUIRE(call("run vortex.toml --out blind 'output={fields_every=4}'", folder).code == 0);
  REQUIRE(call("run vortex.toml --out none time.end=0.1 output.frames=0.1 output.fields_every=0.2 "
               "output.fields_from=0.3",
               folder)
              .code == 0);
  struct Row {
    std::string arguments, about;
  };
  for (const auto& [arguments, about] :
       std::vector<Row>{{"nowhere --from 0 --to 1", "no such folder"},
                        {"empty --from 0 --to 1", "frames.h5"},
                        {"none --from 0 --to 1", "output.fields_every"},
                        {"blind --from 0 --to 1", "1 picture"},
                        {"r --from 0 --to 0.9", "--to 0.9 is outside"},
                        {"r --from 7 --to 0.1", "from t = 0 to 0.8; --from 7"},
                        {"r --from 0.1 --to 0.1", "no time between"},
                        {"r --from 0 --to 1e-300", "is the least that they tell of"},
                        {"r --from 0.1 0.2 --to 0.3", "pairs"},
                        {"r --from 0.1 0.1 --to 0.3 0.4", "twice forward"},
                        {"r --from 0.1 --to 0.3 --spacing 1e-6", "tracers"},
                        {"r --from 0.1 --to 0.3 --spacing 0", "0 is no number > 0"},
                        {"r --from 0.1 --to 0.3 --spacing nan", "nan is no number > 0"},
                        {"r --from -1 --to 0.3", "-1 is no time"},
                        {"r --from 0.1", "--to"}}) {
    const auto outcome = call("lyapunov " + arguments, folder);
    CAPTURE(arguments, outcome.out, outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find(about) != std::string::npos);
    CHECK_FALSE(fs::exists(folder / "r/lyapunov.h5"));
  }
  folder.write("r/fields.h5", "");
  const auto damaged = call("lyapunov r --from 0.1 --to 0.3", folder);
  CHECK(damaged.code == 2);
  CHECK(damaged.err.find("fields.h5: no picture can be read there; the file is damaged") !=
        std::string::npos);
}

TEST_CASE("where nothing is known a warning says so, and no figure of other exponents stays") {
  const TemporaryFolder folder;
  folder.write("vortex.toml", vortex);
  {
    const NoFigures quick(folder);
    REQUIRE(call("run vortex.toml --out r", folder).code == 0);
  }
  REQUIRE(call("lyapunov r --from 0 --to 0.4", folder).code == 0);
  REQUIRE(fs::exists(folder / "r/lyapunov.png"));
  const auto nothing = call("lyapunov r --from 0 --to 0.4 --spacing 1e9", folder);
  CAPTURE(nothing.out, nothing.err);
  CHECK(nothing.code == 0);
  CHECK(nothing.err.find("nothing is known") != std::string::npos);
  CHECK_FALSE(fs::exists(folder / "r/lyapunov.png"));
}

TEST_CASE("pictures too far apart in time are warned of") {
  const SceneFolder folder("vortex.toml", vortex);
  // Two vortices turn about each other by half a turn in 1.1, and pass a place as fast as that.
  REQUIRE(call("run vortex.toml --out r initial.kind=corotating_pair initial.core=0.12 "
               "initial.separation=0.5 time.end=4 output.frames=4 output.fields_every=0.8",
               folder)
              .code == 0);
  const auto few = call("lyapunov r --from 4 --to 3", folder);
  CAPTURE(few.err);
  CHECK(few.code == 0);
  CHECK(few.err.find("warning: r/fields.h5: between its pictures") != std::string::npos);
}

TEST_CASE("exponents of a body that plunges are drawn: backward, forward, and with SPH particles") {
  const TemporaryFolder folder;
  folder.write("plunging.toml", plunging);
  {
    const NoFigures quick(folder);
    REQUIRE(call("run plunging.toml --out r method=sph output.frames=0.3", folder).code == 0);
  }
  const auto done = call("lyapunov r --from 0.3 0.3 0.6 --to 0.6 0.2 0.3", folder);
  CAPTURE(done.out, done.err);
  CHECK(done.code == 0);
  CHECK(done.out.starts_with("r/lyapunov.png\n"));
  CHECK(fs::file_size(folder / "r/lyapunov.png") > 10000);
}

TEST_CASE("a run that replaces another takes its exponents away") {
  const SceneFolder folder("vortex.toml", vortex);
  REQUIRE(call("run vortex.toml --out r", folder).code == 0);
  REQUIRE(call("lyapunov r --from 0.4 --to 0", folder).code == 0);
  CHECK(fs::exists(folder / "r/lyapunov.xdmf"));
  REQUIRE(call("run vortex.toml --out r --overwrite time.end=0.4", folder).code == 0);
  CHECK_FALSE(fs::exists(folder / "r/lyapunov.h5"));
  CHECK_FALSE(fs::exists(folder / "r/lyapunov.xdmf"));
}
