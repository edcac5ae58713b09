#include <catch2/catch.hpp>
#include <cmath>

#include "app/loop/run.hpp"
#include "app/program.hpp"
#include "checks/checks.hpp"
#include "checks/history_rows.hpp"

using namespace vortree;
using namespace vortree::test;
using checks::Verdict;

namespace {

const Verdict good{"a_max", 0.2, {0.1}}, bad{"b_max", 0.2, {0.3}};
const Verdict late{"c_max", 0.2, {{}, "the run ends at T = 1"}};
const Verdict later{"d_max", 0.2, {{}, "the run ends at T = 1"}};
const Verdict unknown{"e_max", 0.2, {{}, "no frame"}};

std::string line(const std::vector<Verdict>& list) {
  return checks::verdict_line(list);
}

}  // namespace

TEST_CASE(
    "a number is passed or missed, at its bound passed; NaN is missed; no number is neither") {
  CHECK(good.passed());
  CHECK(bad.missed());
  CHECK(Verdict{"a", 0.2, {0.2}}.passed());
  CHECK(Verdict{"a", 0.2, {NAN}}.missed());
  CHECK(Verdict{"a", 0.2, {INFINITY}}.missed());
  for (const Verdict& v : {good, bad, late}) CHECK_FALSE((v.passed() && v.missed()));
  CHECK_FALSE(late.passed());
  CHECK_FALSE(late.missed());
}

TEST_CASE("the line of a check names what was reached, missed and not reached, and why") {
  CHECK(line({}) == "nothing to check");
  CHECK(line({good}) == "check passed: a_max 0.1 of 0.2");
  CHECK(line({good, bad}) == "check FAILED: a_max 0.1 of 0.2, b_max 0.3 of 0.2 (missed)");
  CHECK(line({late, good, unknown, later}) ==
        "check passed: a_max 0.1 of 0.2; not reached: c_max, d_max (the run ends at T = 1), e_max "
        "(no frame)");
  CHECK(line({late, later}) ==
        "nothing of the check was reached: c_max, d_max (the run ends at T = 1)");
}

TEST_CASE("a run has passed unless something was missed, and not before its end") {
  using app::RunResult;
  CHECK(RunResult{.finished = true, .verdicts = {good, late}}.passed());
  CHECK(RunResult{.finished = true, .verdicts = {late}}.passed());
  CHECK_FALSE(RunResult{.finished = true, .verdicts = {good, bad}}.passed());
  CHECK_FALSE(RunResult{.finished = false, .verdicts = {good}}.passed());
}

TEST_CASE("a cubic through four entries is exact for cubics, and there is none outside a table") {
  checks::Series x, y;
  for (double at : {0.0, 0.3, 1.0, 1.2, 2.0}) {
    x.push_back(at);
    y.push_back(at * at * at - at);
  }
  for (double at : {0.0, 0.1, 0.5, 1.1, 1.9, 2.0})
    CHECK(*checks::interpolated(x, y, at) == Approx(at * at * at - at).margin(1e-14));
  CHECK_FALSE(checks::interpolated(x, y, -0.01));
  CHECK_FALSE(checks::interpolated(x, y, 2.01));
  CHECK_FALSE(checks::interpolated({0, 1, 2}, {0, 1, 2}, 1));
  CHECK(std::isnan(*checks::interpolated(x, {0, NAN, 0, 0, 0}, 0.5)));
  CHECK(checks::deviation(3, 2) == 0.5);
  CHECK(checks::deviation(3, 0) == 3);
  CHECK(checks::share(3, -2) == -1.5);
  CHECK(checks::share(0, 0) == 0);
  CHECK(checks::largest_of({1, -3, 2}) == 3);
  CHECK(std::isnan(checks::largest_of({1, NAN, 2})));
  CHECK(std::isnan(checks::largest_of({NAN, 1})));
}

TEST_CASE("a run that was too short says so in its summary, and leaves 0") {
  const SceneFolder folder("known.csv", "T,C_D\n2,1\n3,1\n4,1\n5,1\n");
  folder.write("cylinder.toml",
               "accuracy = 0.1\n[flow]\nreynolds = 50\nstream = [1, 0]\n[body]\nradius = 0.5\n"
               "[time]\nend = 0.3\n[check]\ndrag_reference = \"known.csv\"\ndrag_max = 0.1\n"
               "drag_from = 2\n");
  const auto outcome = call("run cylinder.toml", folder);
  CAPTURE(outcome.out, outcome.err);
  CHECK(outcome.code == 0);
  CHECK(outcome.out.find("nothing of the check was reached: drag_max (the run ends at T = 0.6)") !=
        std::string::npos);
  const auto summary = shell(
      "/usr/bin/python3 -c \"import json; c = "
      "json.load(open('runs/cylinder/summary.json'))['check'];"
      " print(c['passed'], *c['drag_max'].values(), sep='|')\"",
      folder);
  CHECK(summary.out == "None|0.1|None|None|not reached|the run ends at T = 0.6\n");
  const auto both = call("run cylinder.toml check.lift_max=1 --out both", folder);
  CHECK(both.code == 0);
  CHECK(both.out.find("check passed: lift_max ") != std::string::npos);
  CHECK(text_of(folder / "both/summary.json").find("\"status\": \"passed\"") != std::string::npos);
  CHECK(call("run cylinder.toml check.blobs_max=1 --out missed", folder).code == 1);
}
