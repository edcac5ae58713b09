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
assert all(notes[word] for word in ('machine', 'compiler', 'flags', 'commit', 'anchors'))
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
