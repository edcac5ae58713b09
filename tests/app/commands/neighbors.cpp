#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "app/program.hpp"
#include "bench/sets/particle_sets.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

void write_set(const fs::path& file, const std::string& name) {
  const bench::ParticleSet set = bench::make_particles(name);
  write_particles(file, {{"x", set.x}, {"y", set.y}, {"reach", set.reach}});
}

// Whatever python prints of the rows of a file, f, and of a line of JSON, d.
std::string ask(const TemporaryFolder& folder, const std::string& file, const std::string& line,
                const std::string& question) {
  folder.write("line.json", line);
  folder.write("ask.py", "import h5py, json\nimport numpy as np\nf = h5py.File('" + file +
                             "')\nd = json.load(open('line.json'))\n"
                             "rows = [frozenset(f['index'][a:b].tolist()) for a, b in "
                             "zip(f['start'][:-1], f['start'][1:])]\n" +
                             question + "\n");
  const auto answer = shell("/usr/bin/python3 ask.py", folder);
  REQUIRE(answer.err == "");
  return answer.out.substr(0, answer.out.find('\n'));
}

}  // namespace

TEST_CASE("neighbors are written in compressed rows, the same by every method") {
  const TemporaryFolder folder;
  write_set(folder / "in.h5", "cyl:3:20");
  std::set<std::string> answers;
  for (const std::string method :
       {"qcg", "level-grids", "linked-list", "leaf-quadtree", "all-pairs"}) {
    const auto outcome = call("neighbors in.h5 --out out.h5 --method " + method, folder);
    CAPTURE(method, outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(outcome.err.empty());
    answers.insert(ask(folder, "out.h5", outcome.out,
                       "print(f['start'].dtype, f['index'].dtype, len(f['start']) == d['n'] + 1, "
                       "len(f['index']) == d['pairs'], hash(tuple(hash(r) for r in rows)))"));
  }
  REQUIRE(answers.size() == 1);
  CHECK(answers.begin()->starts_with("int64 int32 True True"));
}

TEST_CASE("each pair once is half of both ways, by rule max and mean") {
  const TemporaryFolder folder;
  write_set(folder / "in.h5", "cyl:4:20");
  for (const std::string rule : {"max", "mean"}) {
    const auto both = call("neighbors in.h5 --out both.h5 --rule " + rule, folder);
    const auto once = call("neighbors in.h5 --out once.h5 --half --rule " + rule, folder);
    REQUIRE(once.code == 0);
    const std::string question = "print(d['pairs'], d['rule'], d['half'])";
    const std::string full = ask(folder, "both.h5", both.out, question);
    const std::string half = ask(folder, "once.h5", once.out, question);
    CHECK(full.ends_with(rule + " False"));
    CHECK(half.ends_with(rule + " True"));
    CHECK(std::stol(full) == 2 * std::stol(half));
  }
}

TEST_CASE("a line of JSON says what was done") {
  const TemporaryFolder folder;
  write_set(folder / "in.h5", "uni:10");
  const auto outcome =
      call("neighbors in.h5 --out out.h5 --rule own --repeat 3 --threads 1", folder);
  REQUIRE(outcome.code == 0);
  CHECK(std::ranges::count(outcome.out, '\n') == 1);
  CHECK(outcome.out.starts_with(R"({"n":100,"method":"qcg","builder":"reverse","threads":1,)"));
  CHECK(ask(folder, "out.h5", outcome.out, "print(*d, *d['seconds'])") ==
        "n method builder threads rule half pairs peak_bytes seconds tree search total io");
  CHECK(ask(folder, "out.h5", outcome.out, "print(d['n'], d['method'], d['threads'], d['rule'])") ==
        "100 qcg 1 own");
}

TEST_CASE("no particles have no neighbors, a reach of zero reaches nobody") {
  const TemporaryFolder folder;
  write_particles(folder / "none.h5", {{"x", {}}, {"y", {}}, {"reach", {}}});
  write_particles(folder / "zero.h5", {{"x", {0, 0, 1}}, {"y", {0, 0, 0}}, {"reach", {0, 0, 1.5}}});
  const auto none = call("neighbors none.h5 --out out.h5", folder);
  CAPTURE(none.err);
  REQUIRE(none.code == 0);
  CHECK(ask(folder, "out.h5", none.out, "print(f['start'][:].tolist(), d['pairs'])") == "[0] 0");
  const auto zero = call("neighbors zero.h5 --out out.h5", folder);
  REQUIRE(zero.code == 0);
  CHECK(ask(folder, "out.h5", zero.out, "print([sorted(r) for r in rows])") ==
        "[[2], [2], [0, 1]]");
}

TEST_CASE("wrong particle files and options are refused with one line") {
  const TemporaryFolder folder;
  write_particles(folder / "bad.h5", {{"x", {0, 1}}, {"y", {0, 0}}, {"reach", {1, -2}}});
  write_particles(folder / "nan.h5", {{"x", {0, 1}}, {"y", {0, 0}}, {"reach", {1, NAN}}});
  write_particles(folder / "short.h5", {{"x", {0, 1}}, {"y", {0, 0}}, {"reach", {1}}});
  write_particles(folder / "bare.h5", {{"x", {0, 1}}, {"y", {0, 0}}});
  write_particles(folder / "good.h5", {{"x", {0, 1}}, {"y", {0, 0}}, {"reach", {1, 1}}});
  const std::pair<std::string, std::string> rows[] = {
      {"bad.h5 --out o.h5", "bad.h5: reach[1] is -2; it must be >= 0"},
      {"nan.h5 --out o.h5", "nan.h5: reach[1] is nan; finite numbers were expected"},
      {"short.h5 --out o.h5", "short.h5: reach has 1 values, but x has 2"},
      {"bare.h5 --out o.h5", "bare.h5: there is no dataset reach"},
      {"good.h5 --out no/o.h5", "no"},
      {"good.h5", "--out"},
      {"good.h5 --out o.h5 --rule all", "all"},
      {"good.h5 --out o.h5 --method magic", "magic"},
      {"good.h5 --out o.h5 --rule own --half", "not symmetric"}};
  for (const auto& [arguments, about] : rows) {
    const auto outcome = call("neighbors " + arguments, folder);
    CAPTURE(arguments, outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find(about) != std::string::npos);
  }
}

TEST_CASE("in a periodic box every method lists the nearest images") {
  const TemporaryFolder folder;
  bench::ParticleSet set = bench::make_particles("cyl:3:10");
  for (auto* values : {&set.x, &set.y}) {
    const double least = std::ranges::min(*values);
    for (double& value : *values) value -= least;
  }
  write_particles(folder / "in.h5", {{"x", set.x}, {"y", set.y}, {"reach", set.reach}});
  const double length = 1.001 * std::ranges::max(set.x);
  const std::string lengths = fmt::format("{},{}", length, 1.02 * length);
  std::set<std::string> answers;
  for (const std::string method : {"qcg", "level-grids", "leaf-quadtree", "r-tree", "all-pairs"}) {
    const auto outcome = call("neighbors in.h5 --out out.h5 --rule mean --periodic " + lengths +
                                  " --repeat 2 --method " + method,
                              folder);
    CAPTURE(method, outcome.err);
    REQUIRE(outcome.code == 0);
    answers.insert(ask(
        folder, "out.h5", outcome.out,
        "i = h5py.File('in.h5')\nx, y, r = i['x'][:], i['y'][:], i['reach'][:]\n"
        "def apart(x, length):\n"
        "  d = x[:, None] - x\n"
        "  return np.minimum(abs(d), np.minimum(abs(d - length), abs(d + length)))\n"
        "L = d['periodic']\n"
        "near = np.hypot(apart(x, L[0]), apart(y, L[1])) < (r[:, None] + r) / 2\n"
        "truth = [frozenset(np.flatnonzero(row).tolist()) - {k} for k, row in enumerate(near)]\n"
        "print(rows == truth, d['pairs'] == sum(map(len, rows)), f.attrs['period_x'] == L[0], "
        "f.attrs['period_y'] == L[1])"));
  }
  CHECK(answers == std::set<std::string>{"True True True True"});
}

TEST_CASE("a length of the box is that of both directions, and of 0 one does not go around") {
  const TemporaryFolder folder;
  write_particles(folder / "in.h5", {{"x", {0.1, 0.9}}, {"y", {0.1, 0.9}}, {"reach", {0.5, 0.5}}});
  const auto pairs = [&](const std::string& box) {
    const auto outcome = call("neighbors in.h5 --out o.h5 --periodic " + box, folder);
    CAPTURE(outcome.err);
    REQUIRE(outcome.code == 0);
    return ask(folder, "o.h5", outcome.out, "print(d['pairs'])");
  };
  CHECK(pairs("1") == "2");
  CHECK(pairs("1,1") == "2");
  CHECK(pairs("1,0") == "0");
  CHECK(pairs("0") == "0");
  for (const auto& [box, about] : std::vector<std::pair<std::string, std::string>>{
           {"0.9", "in.h5: x[1] is 0.9; in the periodic box it must be in [0, 0.9)"},
           {"1,0.5", "in.h5: y[1] is 0.9"},
           {"-1", "-1 is no length L or LX,LY"},
           {"1,2,3", "1,2,3 is no length"},
           {"1,", "1, is no length"},
           {"inf", "inf is no length"}}) {
    const auto outcome = call("neighbors in.h5 --out o.h5 --periodic " + box, folder);
    CAPTURE(box, outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.err.find(about) != std::string::npos);
  }
}
