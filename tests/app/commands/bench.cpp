#include <catch2/catch.hpp>

#include "app/program.hpp"

using namespace vortree::test;

namespace {

/// Runs a bench that must succeed without a word on standard error; returns what it says.
std::string bench(const std::string& words, const TemporaryFolder& folder) {
  const auto outcome = call("bench " + words, folder);
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.err.empty());
  return outcome.out;
}

/// What some Python says of a table, given as `notes` (of its origin) and `rows`.
std::string of_table(const std::string& file, const std::string& script,
                     const TemporaryFolder& folder) {
  folder.write("read.py", R"(
import csv
lines = open(')" + file + R"(').read().splitlines()
notes = dict(line[2:].split(': ', 1) for line in lines if line.startswith('#'))
rows = list(csv.DictReader(line for line in lines if not line.startswith('#')))
assert all(notes[word] for word in ('machine', 'compiler', 'flags', 'commit'))
)" + script);
  const auto read = shell("/usr/bin/python3 read.py", folder);
  CHECK(read.err == "");
  return read.out;
}

}  // namespace

TEST_CASE("the velocity bench leaves a table with its origin, and figures") {
  const TemporaryFolder folder;
  const auto said = bench("velocity --quick --largest 300 --threads 1 --out new/results", folder);
  CHECK(said.find("ringwake       300 boxes") != std::string::npos);
  CHECK(fs::exists(folder / "new/results/velocity_n.png"));
  CHECK(of_table("new/results/velocity.csv", R"(
print(sorted({row['set'] for row in rows}), sorted({row['n'] for row in rows}))
methods = {name: {row['method'] for row in rows if row['set'] == name} for name in ('uniform', 'blobs')}
print({'boxes', 'direct'} <= methods['uniform'] == methods['blobs'] - {'grid'})
print(all(float(row['seconds']) > 0 and float(row['relative_l2']) <= float(row['tolerance'] or 1)
          for row in rows))
)",
                 folder) ==
        "['blobs', 'hard', 'ringwake', 'uniform'] ['100', '300']\nTrue\nTrue\n");
}

TEST_CASE("the tree bench leaves its tables, and figures") {
  const TemporaryFolder folder;
  bench("trees --quick --largest 1000 --threads 1 --out new/results", folder);
  for (const char* name : {"trees_phases.png", "trees_reuse.png"}) {
    CHECK(fs::exists(folder / "new/results" / name));
  }
  CHECK(of_table("new/results/trees.csv", R"(
print(sorted({row['builder'] for row in rows}))
shapes = {(row['set'], row['n_ctrl'], row['cells'], row['childless'], row['depth']) for row in rows}
print(len(shapes) == len({(row['set'], row['n_ctrl']) for row in rows}))
)",
                 folder) ==
        "['climb', 'forward', 'partition', 'printed', 'printed_known', 'reverse']\nTrue\n");
}

TEST_CASE("the neighbor bench leaves a table with its origin, and figures") {
  const TemporaryFolder folder;
  bench("neighbors --quick --largest 1100 --threads 2 --out nb", folder);
  CHECK(fs::exists(folder / "nb/neighbors_scaled.png"));
  const auto again = call("bench neighbors --quick --largest 1100 --out nb", folder);
  CHECK(again.code == 2);
  CHECK(again.err.find("--overwrite") != std::string::npos);
  CHECK(of_table("nb/neighbors.csv", R"(
print(sorted({row['set'] for row in rows}), sorted({row['threads'] for row in rows}))
print(sorted({row['method'] for row in rows}), sorted({row['rule'] for row in rows}))
print(all(float(row['seconds']) > 0 and int(row['pairs']) > 0 for row in rows))
)",
                 folder) ==
        "['cyl:5:17', 'uni:32'] ['1', '2']\n['all-pairs', 'leaf-quadtree', "
        "'level-grids', 'linked-list', 'qcg', 'r-tree', 'uniform-grid'] ['max', 'mean', 'own']\n"
        "True\n");
}

TEST_CASE("a frames file without frames is no flow to measure") {
  const TemporaryFolder folder;
  write_particles(folder / "p.h5", {{"x", {0, 1}}});
  const auto outcome = call("bench trees --quick --largest 100 --blobs p.h5 --out b", folder);
  CHECK(outcome.code == 2);
  CHECK(outcome.err == "vortree: p.h5 has no frames\n");
}

TEST_CASE("the step bench leaves every phase of every flow by every variant, and a figure") {
  const TemporaryFolder folder;
  const auto said = bench("step --quick --largest 1000 --threads 2 --out new/steps", folder);
  CHECK(said.find("cylinder_re200       unmerged    2") != std::string::npos);
  CHECK(fs::exists(folder / "new/steps/step_phases.png"));
  const auto again = call("bench step --quick --largest 1000 --out new/steps", folder);
  CHECK(again.code == 2);
  CHECK(again.err.find("--overwrite") != std::string::npos);
  CHECK(of_table("new/steps/step.csv", R"(
flows = ('cylinder_re550_quick', 'cylinder_re200', 'naca0012')
variants = ('fmm', 'boxes', 'direct', 'unmerged')
phases = ('convect', 'wall', 'split', 'merge', 'output', 'step')
every = [(f, v, t, p) for f in flows for t in ('1', '2') for v in variants for p in phases]
print([tuple(row[k] for k in ('flow', 'variant', 'threads', 'phase')) for row in rows] == every)

# The printed digits of the phases add up to those of the step, and belong to each other.
def near(a, b): return abs(a - b) <= 3e-5 * abs(b)
for k in range(0, len(rows), 6):
    *parts, whole = [{key: float(row[key]) for key in ('ns', 'share', 'seconds', 'blobs')}
                     for row in rows[k:k + 6]]
    for key in ('ns', 'share', 'seconds'):
        assert near(sum(part[key] for part in parts), whole[key])
    assert all(near(1e-9 * one['ns'] * one['blobs'], one['seconds']) for one in parts + [whole])
    assert near(float(rows[k + 5]['particle_steps']) * 1e-9 * whole['ns'], 1)
    assert all(one['ns'] > 0 for one in parts)

# What was done has nothing to do with the number of threads.
steps = {(row['flow'], row['variant'], row['threads']): row for row in rows if row['phase'] == 'step'}
counts = {key: dict(part.split('=') for part in row['counts'].split(';'))
          for key, row in steps.items()}
for f in flows:
    for v in variants:
        one, two = steps[f, v, '1'], steps[f, v, '2']
        assert all(one[key] == two[key] for key in ('drag', 'counts', 'blobs', 'panels'))
        assert float(counts[f, v, '1']['released']) == float(one['panels']) > 100
    assert float(counts[f, 'fmm', '1']['laid']) > 0
    assert counts[f, 'unmerged', '1']['merged'] == '0' < counts[f, 'fmm', '1']['merged']

# Followed until there are so many blobs, not to the end.
assert all(float(steps[f, 'fmm', '1']['blobs']) < 2500 for f in flows)

# Velocities are summed to 4e-5 or better: of the drag of the first step that much of itself. Mergers
# come after it.
for f in flows:
    drag = {v: float(steps[f, v, '1']['drag']) for v in variants}
    assert abs(drag['fmm'] - drag['direct']) <= 4e-5 * abs(drag['direct']) > 0
    assert abs(drag['boxes'] - drag['direct']) <= 4e-5 * abs(drag['direct'])
    assert drag['boxes'] != drag['direct'] != drag['fmm'] == drag['unmerged']
)",
                 folder) == "True\n");
}

TEST_CASE("the step bench goes on with runs, and refuses what is none") {
  const TemporaryFolder folder;
  const NoFigures quick(folder);
  const std::string start = "[flow]\nnu = 1e-3\n[initial]\n";
  folder.write("vortex.toml", start + R"(kind = "lamb_oseen"
circulation = 1.0
core = 0.2
[cores]
sigma_0 = 0.06
sigma_max = 0.1
[time]
dt = 0.02
end = 0.1
)");
  folder.write("sph.toml", "method = \"sph\"\n" + start + R"(kind = "taylor_green"
wavelength = 1
[sph]
outside = "periodic"
spacing = 0.125
[time]
dt = 0.01
end = 0.02
)");
  REQUIRE(call("run vortex.toml --out 'runs/a,b'", folder).code == 0);
  bench("step --quick --threads 1 --run 'runs/a,b' --out kept", folder);
  CHECK(of_table("kept/step.csv", R"(
print(sorted({row['flow'] for row in rows}), sorted({row['variant'] for row in rows}))
print({row['panels'] for row in rows}, {row['drag'] for row in rows})
)",
                 folder) == "['a,b'] ['boxes', 'direct', 'fmm', 'unmerged']\n{'0'} {''}\n");
  REQUIRE(call("run sph.toml --out sph", folder).code == 0);
  fs::create_directory(folder / "empty");
  const std::pair<const char*, const char*> rows[] = {
      {"step --run empty", "empty holds no run: there is no frames.h5"},
      {"step --run 'runs/a,b' nowhere", "nowhere holds no run"},
      {"step --run sph", "sph: a run by method = \"sph\"; steps are measured of vortices"},
      {"step --run ''", "--run"},
      {"step --blobs p.h5", "--blobs is for bench trees alone"},
      {"velocity --run empty", "--run is for bench step alone"},
      {"step --largest 10", "--largest"},
      {"step --run 'runs/a,b' --out kept", "--overwrite"},
  };
  for (const auto& [arguments, about] : rows) {
    CAPTURE(arguments);
    const auto outcome = call(std::string("bench ") + arguments, folder);
    CHECK(outcome.code == 2);
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.err.find(about) != std::string::npos);
  }
}
