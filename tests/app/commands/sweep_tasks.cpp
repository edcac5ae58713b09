#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <regex>
#include <set>

#include "app/commands/sweep/share.hpp"
#include "app/lone_vortex.hpp"
#include "app/program.hpp"
#include "io/input_error.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

const std::string list = "run vortex.toml time.scheme=rk4,rk2 time.dt=0.02,0.01,0.005 ";

/// A table without what differs from run to run of the same: load, date and the two columns of
/// seconds.
std::string timeless(const fs::path& file) {
  std::string kept;
  std::istringstream lines(text_of(file));
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("# load: ") && !line.starts_with("# date: ")) kept += line + "\n";
  return std::regex_replace(
      kept, std::regex("\n([^,\n]*,[^,\n]*,[0-9]+,[0-9.]+,[0-9.]+),[^,\n]+,[^,\n]+,"), "\n$1,,,");
}

/// What a program printed, without the column of seconds.
std::string timeless_words(const std::string& out) {
  return std::regex_replace(out, std::regex("(rk[24]  *[0-9.]+  *[0-9]+  *[0-9]+) +[0-9.e-]+"),
                            "$1");
}

/// The folder is named at the end of what is printed.
std::string table_in(const std::string& out) {
  const auto from = out.find("time.scheme  time.dt"), to = out.find("results in", from);
  return from == std::string::npos ? "" : timeless_words(out.substr(from, to - from));
}

std::string last_line(const std::string& text) {
  const auto end = text.find_last_not_of('\n');
  return text.substr(text.rfind('\n', end) + 1, end - text.rfind('\n', end));
}

}  // namespace

TEST_CASE("every run of a list is one task's, however many tasks there are") {
  for (const std::size_t runs : {1, 2, 7, 12})
    for (std::size_t tasks = 1; tasks <= 15; ++tasks) {
      std::multiset<std::size_t> taken;
      for (std::size_t k = 1; k <= tasks; ++k)
        for (const std::size_t run : app::runs_of({k, tasks}, runs)) taken.insert(run);
      CHECK(taken.size() == runs);
      CHECK(std::set(taken.begin(), taken.end()).size() == runs);
      CHECK(*taken.rbegin() == runs - 1);
    }
  CHECK(app::runs_of({2, 3}, 7) == std::vector<std::size_t>{1, 4});
  CHECK(app::runs_of(app::share_in("4"), 7) == std::vector<std::size_t>{3});
  CHECK_THROWS_AS(app::runs_of(app::share_in("8"), 7), io::InputError);
  for (const char* wrong : {"0/3", "4/3", "0", "", "/", "1/", "/2", "1/0", "a/2", "-1/2", "1/2/3",
                            "1.5/2", "1 /2", "99999999999999999999/3"})
    CHECK_THROWS_AS(app::share_in(wrong), std::invalid_argument);
}

TEST_CASE("tasks in any order and their table are a sweep in one go, byte for byte") {
  const TemporaryFolder folder;
  const NoFigures quick(folder);
  folder.write("vortex.toml", lone_vortex_by_pairs);
  const auto whole = call(list + "--out whole", folder);
  CAPTURE(whole.err);
  REQUIRE(whole.code == 0);
  for (const int task : {3, 1, 2}) {
    const auto part = call(fmt::format("{} --out parts --only {}/3", list, task), folder);
    CAPTURE(part.out, part.err);
    CHECK(part.code == 0);
    CHECK(part.out.find("2 of 6 runs are in parts; the table of all: vortree sweep parts") !=
          std::string::npos);
    CHECK_FALSE(fs::exists(folder / "parts/sweep.csv"));
  }
  const auto gathered = call("sweep parts", folder);
  CAPTURE(gathered.out, gathered.err);
  CHECK(gathered.code == 0);
  CHECK(timeless(folder / "parts/sweep.csv") == timeless(folder / "whole/sweep.csv"));
  CHECK(timeless(folder / "parts/sweep.csv").find("\nrk2,0.01,8,") != std::string::npos);
  REQUIRE(!table_in(whole.out).empty());
  CHECK(table_in(gathered.out) == table_in(whole.out));
  // The seconds, too, are those that the runs told.
  const std::string csv = text_of(folder / "whole/sweep.csv");
  CHECK(call("sweep whole", folder).code == 0);
  CHECK(text_of(folder / "whole/sweep.csv") == csv);
}

TEST_CASE("tasks that start at once share a folder; a sweep in one go there is refused") {
  const TemporaryFolder folder;
  const NoFigures quick(folder);
  folder.write("vortex.toml", lone_vortex_by_pairs);
  std::string line;
  for (int task = 1; task <= 6; ++task)
    line += fmt::format("'{}' {} --out deep/er/parts --only {}/6 & p{}=$!; ", VORTREE_PROGRAM, list,
                        task, task);
  for (int task = 1; task <= 6; ++task) line += fmt::format("wait $p{} || exit 1; ", task);
  const auto all = shell(line, folder);
  CAPTURE(all.out, all.err);
  CHECK(all.code == 0);
  CHECK(call("sweep deep/er/parts", folder).code == 0);
  fs::create_directory(folder / "held");
  const auto held =
      shell(fmt::format("flock -s held '{}' {} --out held", VORTREE_PROGRAM, list), folder);
  CHECK(held.code == 2);
  CHECK(held.err.find("another vortree writes there") != std::string::npos);
}

TEST_CASE("what is missing, unfinished or failed is a gap in the table, and told") {
  const TemporaryFolder folder;
  const NoFigures quick(folder);
  folder.write("vortex.toml", lone_vortex_by_pairs);
  const std::string words = "run vortex.toml time.end=0.08,1000,0.04 --out parts ";
  CHECK(call(words + "--only 1", folder).code == 0);
  const auto stopped = interrupted(words + "--only 2", folder, "parts/time.end=1000/report.csv", 3);
  CHECK(stopped.code == 1);
  CHECK(last_line(stopped.err) == "vortree: the sweep has stopped in run 2 of 3");
  const auto some = call("sweep parts", folder);
  CAPTURE(some.out, some.err);
  CHECK(some.code == 1);
  CHECK(
      last_line(some.out).starts_with("0 of 3 runs failed, 0 missed their checks, 1 unfinished, "
                                      "1 missing: time.end=1000 unfinished: its last frame is "
                                      "that of t = "));
  CHECK(last_line(some.out).ends_with("; time.end=0.04 missing: has not begun"));
  const std::string csv = text_of(folder / "parts/sweep.csv");
  CHECK(csv.find("\n0.08,8,") != std::string::npos);
  CHECK(csv.find("\n1000,,,,,,\n0.04,,,,,,\n") != std::string::npos);

  // A run that breaks off says why where others look for it, until it is begun again.
  fs::create_directories(folder / "parts/time.end=0.04/report.csv");
  CHECK(call(words + "--only 3/3", folder).code == 1);
  CHECK(last_line(call("sweep parts", folder).out).find("; time.end=0.04 failed: ") !=
        std::string::npos);
  fs::remove(folder / "parts/time.end=0.04/report.csv");
  CHECK(call(words + "--only 3/3", folder).code == 0);
  CHECK_FALSE(fs::exists(folder / "parts/time.end=0.04/failed.txt"));
  CHECK(last_line(call("sweep parts", folder).out)
            .starts_with("0 of 3 runs failed, 0 missed their checks, 1 unfinished, 0 missing: "));
}

TEST_CASE("a task that was stopped goes on to the same table") {
  const TemporaryFolder folder;
  const NoFigures quick(folder);
  folder.write("vortex.toml", lone_vortex_by_pairs);
  const std::string words = "run vortex.toml cores.sigma_0=0.05,0.06 time.end=4 output.frames=0.5 ";
  const auto stopped = interrupted(words + "--out parts --only 2/2", folder,
                                   "parts/cores.sigma_0=0.06/report.csv", 3);
  CHECK(stopped.code == 1);
  CHECK(call(words + "--out parts --only 2/2", folder).code == 2);  // it has begun
  for (const char* task : {"2/2", "1/2"}) {
    const auto again = call(words + "--out parts --resume --only " + task, folder);
    CAPTURE(again.err);
    CHECK(again.code == 0);
  }
  CHECK(call("sweep parts", folder).code == 0);
  CHECK(call(words + "--out whole", folder).code == 0);
  const std::regex seconds(",[0-9.e-]+,[0-9.e-]+,([0-9.e-]+)\n");
  const auto rows = [&](const char* file) {
    const std::string csv = text_of(folder / file);
    return std::regex_replace(csv.substr(csv.find("\ncores.sigma_0")), seconds, ",$1\n");
  };
  CHECK(rows("parts/sweep.csv") == rows("whole/sweep.csv"));
  // What may change on the way may, but then all have to come there.
  const std::string farther =
      "run vortex.toml cores.sigma_0=0.05,0.06 time.end=5 output.frames=0.5 ";
  CHECK(call(farther + "--out parts --resume --only 1/2", folder).code == 0);
  const auto half = call("sweep parts", folder);
  CAPTURE(half.out);
  CHECK(half.code == 1);
  CHECK(last_line(half.out).find(
            "cores.sigma_0=0.06 unfinished: its last frame is that of t = 4") != std::string::npos);
  CHECK(call(farther + "--out parts --resume --only 2/2", folder).code == 0);
  CHECK(call("sweep parts", folder).code == 0);
}

TEST_CASE("tasks of different lists, and runs of different scenes, do not come together") {
  const TemporaryFolder folder;
  const NoFigures quick(folder);
  folder.write("vortex.toml", lone_vortex_by_pairs);
  REQUIRE(call(list + "--out parts --only 1/6", folder).code == 0);
  const auto refused = [&](const std::string& words, const std::string& about) {
    const auto outcome = call(words, folder);
    CAPTURE(words, outcome.out, outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.err.find(about) != std::string::npos);
  };
  const std::string others = "parts/sweep.json is the list of other runs: time.scheme=rk4,rk2 ";
  refused("run vortex.toml time.scheme=rk4,rk2 time.dt=0.02,0.01 --out parts --only 2/6", others);
  refused(list + "flow.nu=2e-3 --out parts --only 2/6", others);
  refused(list + "flow.nu=2e-3 --out parts --resume --only 2/6", others);
  const std::string scene = text_of(folder / "vortex.toml");
  folder.write("vortex.toml", std::regex_replace(scene, std::regex("1e-3"), "2e-3"));
  refused(list + "--out parts --only 2/6", "vortex.toml as it was before it was changed");
  folder.write("vortex.toml", scene);

  // A run that was made by hand in the folder of another.
  CHECK(call("run vortex.toml time.scheme=rk4 time.dt=0.01 flow.nu=2e-3 --out "
             "parts/time.scheme=rk4,time.dt=0.01",
             folder)
            .code == 0);
  refused("sweep parts", "is a run of another [flow] than its sweep has");
  CHECK_FALSE(fs::exists(folder / "parts/sweep.csv"));
  // The same flow belongs, however it was asked for.
  const auto same = call(
      "run vortex.toml time.dt=0.010 time.scheme=rk4 --overwrite --out "
      "parts/time.scheme=rk4,time.dt=0.01",
      folder);
  CHECK(same.code == 0);
  const auto gathered = call("sweep parts", folder);
  CHECK(gathered.code == 1);
  CHECK(gathered.out.find(", 0 unfinished, 4 missing: ") != std::string::npos);

  CHECK(call("run vortex.toml --out 'parts/by hand'", folder).code == 0);
  CHECK(call("sweep parts", folder)
            .err.find("warning: parts/by hand is no run of the list, and is left out") !=
        std::string::npos);

  refused("sweep nowhere", "nowhere: no such folder");
  refused("sweep parts/time.scheme=rk4,time.dt=0.01", "there is no sweep.json");
  folder.write("parts/sweep.json", "{");
  refused("sweep parts", "is damaged");
}

TEST_CASE("a run that has gone beyond the end of its list is not of it, whatever it began with") {
  const TemporaryFolder folder;
  const NoFigures quick(folder);
  folder.write("vortex.toml", lone_vortex_by_pairs);
  const std::string words = "run vortex.toml cores.sigma_0=0.05,0.06 --out s --resume time.end=";
  for (const char* task : {"1", "2"}) CHECK(call(words + "0.04 --only " + task, folder).code == 0);
  CHECK(call(words + "0.08 --only 1", folder).code == 0);
  CHECK(call(words + "0.04 --only 2", folder).code == 0);  // and the list ends there again
  const bool ended = GENERATE(true, false);
  if (!ended) fs::remove(folder / "s/cores.sigma_0=0.05/summary.json");
  const auto mixed = call("sweep s", folder);
  CAPTURE(ended, mixed.out, mixed.err);
  CHECK(mixed.code == 2);
  CHECK(mixed.err ==
        "vortree: s/cores.sigma_0=0.05: the last frame is that of t = 0.08, which is beyond "
        "time.end = 0.04 of its sweep: it does not belong to the others\n");
  CHECK_FALSE(fs::exists(folder / "s/sweep.csv"));
  for (const char* task : {"1", "2"}) CHECK(call(words + "0.08 --only " + task, folder).code == 0);
  CHECK(call("sweep s", folder).code == 0);
}

TEST_CASE("what is said of another list helps") {
  const TemporaryFolder folder;
  const NoFigures quick(folder);
  folder.write("vortex.toml", lone_vortex_by_pairs);
  const std::string words = "run vortex.toml --out s cores.sigma_0=0.05,0.06";
  REQUIRE(call(words + " --only 1", folder).code == 0);
  for (const char* way : {"", " --overwrite", " --resume"}) {
    const auto other = call(words + ",0.07 --only 3" + way, folder);
    CAPTURE(way, other.err);
    CHECK(other.code == 2);
    CHECK(other.err ==
          "vortree: s/sweep.json is the list of other runs: cores.sigma_0=0.05,0.06; --out DIR "
          "leaves it alone; only a sweep without --only replaces it, with --overwrite\n");
  }
  const std::string stickier = words + " flow.nu=2e-3 --only 2";
  CHECK_THAT(call(stickier, folder).err, Catch::Contains("; --overwrite replaces it, --out DIR"));
  CHECK(call(stickier + " --overwrite", folder).code == 0);
  CHECK_THAT(call("sweep s", folder).err, Catch::Contains("is a run of another [flow]"));
  CHECK(call(words + ",0.07 --overwrite", folder).code == 0);
}

TEST_CASE("a table that is a link to what is no table of a sweep is refused") {
  const TemporaryFolder folder;
  const NoFigures quick(folder);
  folder.write("vortex.toml", lone_vortex_by_pairs);
  const std::string words = "run vortex.toml --out s cores.sigma_0=0.05,0.06";
  for (const char* task : {" --only 1", " --only 2"}) REQUIRE(call(words + task, folder).code == 0);
  folder.write("notes.txt", "mine");
  for (const std::string to :
       {"cores.sigma_0=0.05/frames.h5", "cores.sigma_0=0.05/report.csv", "../notes.txt"}) {
    const std::string before = text_of(folder / "s" / to);
    fs::create_symlink(to, folder / "s/sweep.csv");
    for (const std::string& command : {std::string("sweep s"), words + " --overwrite"}) {
      const auto refused = call(command, folder);
      CAPTURE(command, refused.err);
      CHECK(refused.code == 2);
      CHECK(refused.error_lines() == 1);
      CHECK(refused.err.starts_with("vortree: s/sweep.csv is a link to s/" + to));
    }
    CHECK(text_of(folder / "s" / to) == before);
    fs::remove(folder / "s/sweep.csv");
  }
  folder.write("elsewhere.csv", "");
  fs::create_symlink("../elsewhere.csv", folder / "s/sweep.csv");
  CHECK(call("sweep s", folder).code == 0);
  CHECK(text_of(folder / "elsewhere.csv").find("cores.sigma_0") != std::string::npos);
}

TEST_CASE("a task beyond the list has nothing to do; one that cannot be is refused") {
  const TemporaryFolder folder;
  const NoFigures quick(folder);
  folder.write("vortex.toml", lone_vortex_by_pairs);
  const auto idle = call(list + "--only 7/8", folder);
  CHECK(idle.code == 0);
  CHECK(idle.out == "task 7 of 8 has nothing to do: the list has 6 runs\n");
  for (const std::string& words : {list + "--only 9/8", list + "--only 0/8", list + "--only 7",
                                   std::string("run vortex.toml --only 1/2")}) {
    const auto outcome = call(words, folder);
    CAPTURE(words, outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.error_lines() == 1);
  }
  CHECK_FALSE(fs::exists(folder / "runs"));
}
