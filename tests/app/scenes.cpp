#include <catch2/catch.hpp>
#include <regex>

#include "app/install_paths.hpp"
#include "app/program.hpp"

using namespace vortree::test;

namespace {

const std::string ring = R"(title = "A ring"

[flow]
nu = 1e-3

[cores]
sigma_0 = 0.02
sigma_max = 0.03

[initial]
kind = "lamb_oseen"
circulation = 1.0
core = 0.2

[time]
dt = 0.1
end = 1.0
)";

std::string with(std::string text, const std::string& old, const std::string& fresh) {
  const auto at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), fresh);
}

}  // namespace

TEST_CASE("check prints a scene that reads back to itself") {
  const TemporaryFolder folder;
  folder.write("ring.toml", ring);
  const auto first = call("check ring.toml time.end=2", folder);
  CAPTURE(first.err);
  REQUIRE(first.code == 0);
  folder.write("again.toml", first.out);
  const auto second = call("check again.toml", folder);
  CHECK(second.code == 0);
  CHECK(second.out == first.out);
  CHECK(second.out != call("check ring.toml", folder).out);
}

TEST_CASE("a scene that is wrong is refused with one line that names the place") {
  const TemporaryFolder folder;
  struct Row {
    std::string text, overrides, about;
  };
  const auto row = GENERATE(values<Row>({
      {"", "", "scene.toml"},
      {"\x01\x02 nothing of TOML", "", "scene.toml:1"},
      {with(ring, "nu = 1e-3", "nu = -1e-3"), "", "scene.toml:4"},
      {with(ring, "nu = 1e-3", "nu = \"thick\""), "", "scene.toml:4"},
      {with(ring, "nu = 1e-3", "viscosity = 1e-3"), "", "scene.toml:4"},
      {with(ring, "sigma_max = 0.03", "sigma_max = 0.01"), "", "sigma_max"},
      {with(ring, "dt = 0.1", "dt = 0"), "", "scene.toml:16"},
      {with(ring, "[time]", "[tune]"), "", "tune"},
      {ring, "flow.nu=-1", "flow.nu"},
      {ring, "flow.colour=1", "flow.colour"},
      {ring, "flow.nu=thick", "flow.nu"},
      {ring, "nonsense", "nonsense"},
  }));
  folder.write("scene.toml", row.text);
  const auto outcome = call("check scene.toml " + row.overrides, folder);
  CAPTURE(row.about, outcome.out, outcome.err);
  CHECK(outcome.code == 2);
  CHECK(outcome.error_lines() == 1);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.find(row.about) != std::string::npos);
}

TEST_CASE(
    "cases lists the scenes of the shared folder by name and title; a bare name finds them from "
    "anywhere") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "cases");
  folder.write("cases/ring.toml", ring);
  folder.write("cases/a_longer_name.toml", with(ring, "A ring", "Another"));
  folder.write("cases/notes.txt", "");
  setenv("VORTREE_SHARE", folder.path().c_str(), 1);
  CHECK(call("cases", folder).out == "a_longer_name  Another\nring           A ring\n");
  CHECK(call("check ring", folder).code == 0);
  CHECK(call("check ring.toml", folder).code == 0);
  const auto unknown = call("check rung", folder);
  CHECK(unknown.code == 2);
  CHECK(unknown.err.find("a_longer_name, ring") != std::string::npos);
  unsetenv("VORTREE_SHARE");
}

TEST_CASE("every scene that comes with the program is valid") {
  const TemporaryFolder folder;
  std::istringstream lines(call("cases", folder).out);
  int scenes = 0;
  for (std::string line; std::getline(lines, line); ++scenes) {
    const auto outcome = call("check " + line.substr(0, line.find(' ')), folder);
    CAPTURE(line, outcome.err);
    CHECK(outcome.code == 0);
  }
  CHECK(scenes > 0);
}

TEST_CASE("the page of scenes holds the keys that the program prints, to the letter") {
  const TemporaryFolder folder;
  const auto keys = call("check --keys", folder);
  CHECK(keys.code == 0);
  CHECK(keys.err.empty());
  CHECK(keys.out.find("\n| `check.plunge_from` | none |") != std::string::npos);
  const std::string page = text_of(fs::path(vortree::app::share_folder()) / "cases/scenes.md");
  const std::string before = "<!-- ./vortree check --keys -->\n", after = "<!-- end of keys -->";
  const auto begin = page.find(before), end = page.find(after);
  REQUIRE(begin != std::string::npos);
  REQUIRE(end != std::string::npos);
  CHECK(page.substr(begin + before.size(), end - begin - before.size()) == keys.out);
}

TEST_CASE("every run that a page of the project names is of a valid scene") {
  const TemporaryFolder folder;
  const fs::path root = vortree::app::share_folder();
  const std::regex run(R"(vortree run ([a-z][\w./]*(?: [\w.]+=[^\s`]+)*))"), more_values(",[^ ]*");
  int runs = 0;
  for (const char* page : {"README.md", "cases/README.md", "cases/scenes.md"}) {
    const std::string text = text_of(root / page);
    for (std::sregex_iterator it(text.begin(), text.end(), run); it != std::sregex_iterator();
         ++it) {
      std::string words =
          std::regex_replace((*it)[1].str(), more_values, "");  // of a sweep the first
      if (words.starts_with("cases/")) words = (root / words).string();
      const auto outcome = call("check " + words, folder);
      CAPTURE(page, words, outcome.err);
      CHECK(outcome.code == 0);
      ++runs;
    }
  }
  CHECK(runs > 10);
}

TEST_CASE("a run of a scene whose name is no UTF-8 has its figures") {
  const TemporaryFolder folder;
  const fs::path plots = fs::path(vortree::app::share_folder()) / "plots";
  fs::create_directory(folder / "plots");
  for (const char* script : {"_phases.py", "_replaced.py", "_style.py", "cost.py"})
    fs::copy_file(plots / script, folder.path() / "plots" / script);
  folder.write("caf\xe9.toml", text_of(plots / "../cases/lamb_oseen.toml"));
  setenv("VORTREE_SHARE", folder.path().c_str(), 1);
  const auto ran = call("run caf\xe9.toml time.end=0.1", folder);
  unsetenv("VORTREE_SHARE");
  CAPTURE(ran.err);
  CHECK(ran.code == 0);
  CHECK(ran.out.starts_with("runs/caf\\xe9/cost.png\n"));
  CHECK(fs::exists(folder / "runs/caf\xe9/cost.png"));
}

TEST_CASE("plot hands the folder to every script, and reports the one that fails") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "plots");
  fs::create_directory(folder / "a run");
  folder.write("plots/a.py", "import sys; open(sys.argv[1] + '/a.svg', 'w'); print(len(sys.argv))");
  folder.write("plots/_parts.py", "raise SystemExit('never called')");
  setenv("VORTREE_SHARE", folder.path().c_str(), 1);
  const auto drawn = call("plot 'a run'", folder);
  CHECK(drawn.code == 0);
  CHECK(drawn.out == "2\n");
  CHECK(fs::exists(folder / "a run/a.svg"));
  folder.write("plots/b.py", "raise ValueError('no such column')");
  const auto broken = call("plot 'a run'", folder);
  CHECK(broken.code == 1);
  CHECK(broken.error_lines() == 1);
  CHECK(broken.err.find("b.py: ValueError: no such column") != std::string::npos);
  unsetenv("VORTREE_SHARE");
}
