#include "app/commands/sweep/sweep.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "app/commands/sweep/seconds.hpp"
#include "app/commands/sweep/table.hpp"
#include "app/lone_vortex.hpp"
#include "app/program.hpp"
#include "checks/convergence.hpp"
#include "io/input_error.hpp"

using namespace vortree;
using namespace vortree::test;
using app::Axis;

TEST_CASE("a list of values is an axis; commas in brackets and quotes divide nothing") {
  const std::vector<std::string> words{"time.dt=0.1,0.2", "flow.stream=[1,0]", "title=\"a, b\"",
                                       "a.b=[1,2],[3,4]"};
  const app::SweepPlan plan = app::sweep_plan(words);
  CHECK(plan.fixed == std::vector<std::string>{"flow.stream=[1,0]", "title=\"a, b\""});
  CHECK(plan.axes == std::vector<Axis>{{"time.dt", {"0.1", "0.2"}}, {"a.b", {"[1,2]", "[3,4]"}}});
  CHECK_THROWS_AS(app::sweep_plan(std::vector<std::string>{"time.dt=0.1,,0.2"}), io::InputError);
}

TEST_CASE("orders of a power law are its exponent, and what says nothing has none") {
  std::vector<double> h, e;
  for (double a : {0.8, 0.4, 0.1}) {
    h.push_back(a);
    e.push_back(3 * std::pow(a, 2.5));
  }
  const auto p = checks::orders(h, e);
  CHECK(std::isnan(p[0]));
  CHECK(p[1] == Approx(2.5));
  CHECK(p[2] == Approx(2.5));
  CHECK(checks::fitted_order(h, e) == Approx(2.5));
  e[1] = INFINITY;
  CHECK(std::isnan(checks::orders(h, e)[1]));
  CHECK(checks::fitted_order(h, e) == Approx(2.5));
  CHECK(std::isnan(checks::fitted_order(std::vector<double>{1, 1}, std::vector<double>{1, 2})));
  for (const double same : {0.3, 0.0}) {
    const std::vector<double> widths{1, 2, 4}, equal(3, same);
    CHECK(std::isnan(checks::orders(widths, equal)[1]));
    CHECK(std::isnan(checks::fitted_order(widths, equal)));
  }
}

TEST_CASE("a sweep runs the list into folders, and measures the order of the time step") {
  const SceneFolder folder("vortex.toml", lone_vortex);
  const auto outcome = call(
      "run vortex.toml time.scheme=rk4,rk2 time.dt=0.02,0.01,0.005 velocity.method=direct", folder);
  CAPTURE(outcome.out, outcome.err);
  CHECK(outcome.code == 0);
  CHECK(fs::exists(folder / "runs/vortex/time.scheme=rk2,time.dt=0.01/summary.json"));
  // Two fits, one a scheme: the moment of the rings is carried to order 4 + 1 and 2 + 1 (rotation).
  std::istringstream lines(outcome.out);
  std::vector<double> fits;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first;
    double order = 0;
    if (words >> first >> order && first == "all") fits.push_back(order);
  }
  REQUIRE(fits.size() == 2);
  CHECK(fits[0] == Approx(5).margin(0.3));
  CHECK(fits[1] == Approx(3).margin(0.3));
  const std::string csv = text_of(folder / "runs/vortex/sweep.csv");
  CHECK(csv.find("\ntime.scheme,time.dt,steps,particles,particle_steps,seconds,processor_seconds,"
                 "second_moment_max\n") != std::string::npos);
  CHECK(csv.find("\nrk2,0.01,8,") != std::string::npos);
}

TEST_CASE("the table has gaps for what was not reached, for runs that failed and for words") {
  const app::SweepPlan plan{.fixed = {}, .axes = {{"k", {"1", "2", "4"}}}};
  const auto run = [](const std::string& value, checks::Reached a, double b) {
    return app::Member{.values = {value},
                       .result = {.finished = true,
                                  .verdicts = {{"a_max", 0.5, a}, {"b_max", 0.5, {b}}},
                                  .steps = 5,
                                  .most_particles = 7,
                                  .seconds = 1}};
  };
  const checks::Reached late{.value = {}, .why = "the run ends at T = 1"};
  std::vector<app::Member> members{run("1", {0.1}, 0.1), run("2", late, 0.4), run("4", {0.9}, NAN)};
  CHECK(app::table(plan, members) ==
        "  k  steps  particles  seconds  a_max  order  b_max  order\n"
        "  1      5          7        1    0.1           0.1       \n"
        "  2      5          7        1                  0.4   2.00\n"
        "  4      5          7        1    0.9                     \n"
        "all                                     1.58          2.00\n");
  CHECK(app::what_went_wrong(plan, members) ==
        "0 of 3 runs failed, 1 missed their checks: k=4 missed its check: a_max 0.9 of 0.5, b_max "
        "not finite of 0.5");
  members[1] = {.values = {"2"}, .failure = "step 3: too many"};
  CHECK(app::table(plan, members).find("\n  2  failed                     ") != std::string::npos);
  CHECK(app::what_went_wrong(plan, members)
            .starts_with("1 of 3 runs failed, 1 missed their checks: k=2 failed: step 3: too many; "
                         "k=4 missed"));
  CHECK(app::what_went_wrong(plan, std::span(members).first(1)).empty());
  for (app::Member& m : members) m.values = {"word"};
  CHECK(app::table(plan, members).find("all") == std::string::npos);
}

TEST_CASE("an error costs what the line between two runs says, and no run beyond errs more") {
  using Numbers = std::vector<double>;
  // seconds = 0.1/error, out of order; and one without a time.
  const Numbers seconds{5, 100, NAN, 20}, errors{0.02, 0.001, 1e-5, 0.005};
  const auto at = [&](double wanted) { return app::cost_of_error(seconds, errors, wanted); };
  REQUIRE(at(0.003));
  CHECK(at(0.003)->seconds == Approx(0.1 / 0.003));
  CHECK_FALSE(at(0.003)->at_most);
  CHECK(at(0.001)->seconds == Approx(100));
  CHECK_FALSE(at(0.0009));  // nothing is extrapolated
  REQUIRE(at(0.03));
  CHECK(at(0.03)->at_most);
  CHECK(at(0.03)->seconds == 5);
  // What is reached by chance and lost again counts for nothing.
  const auto again =
      app::cost_of_error(Numbers{1, 2, 4, 8}, Numbers{0.01, 0.002, 0.008, 0.001}, 0.003);
  REQUIRE(again);
  CHECK(again->seconds == Approx(4 * std::pow(2, std::log(8 / 3.0) / std::log(8.0))));
  CHECK_FALSE(app::cost_of_error(Numbers{1, 2}, Numbers{0.001, 0.004}, 0.003));
  CHECK_FALSE(app::cost_of_error(Numbers{}, Numbers{}, 0.003));
}

TEST_CASE("a sweep that is held against a drag says what its errors cost, one of others nothing") {
  const auto run = [](const std::string& value, double seconds, double off) {
    return app::Member{.values = {"3", value},
                       .result = {.finished = true,
                                  .verdicts = {{"drag_max", 1, {off}}, {"lift_max", 1, {off}}},
                                  .seconds = seconds,
                                  .processor_seconds = seconds}};
  };
  const app::SweepPlan plan{.fixed = {}, .axes = {{"seed", {"3"}}, {"accuracy", {"4", "2"}}}};
  const std::vector<app::Member> members{run("4", 2, 0.008), run("2", 8, 0.002)};
  CHECK(app::seconds_to_errors(plan, members) ==
        "seconds to 1 % / 0.3 % / 0.1 % by drag_max, seed=3: at most 2 / 5.33 / not reached\n");
  CHECK(app::seconds_to_errors(plan, std::span(members).first(1)).empty());
  const app::SweepPlan flows{.fixed = {}, .axes = {{"seed", {"3"}}, {"flow.nu", {"4", "2"}}}};
  CHECK(app::seconds_to_errors(flows, members).empty());
}

namespace {

std::string last_line(const std::string& text) {
  const auto end = text.find_last_not_of('\n');
  return text.substr(text.rfind('\n', end) + 1, end - text.rfind('\n', end));
}

}  // namespace

TEST_CASE("a sweep of which a run fails or misses its check runs the others, and leaves 1") {
  const SceneFolder folder("vortex.toml", lone_vortex);
  fs::create_directories(folder / "failing");
  folder.write("failing/time.dt=0.02", "where the folder of a run should be");
  const auto failing = call("run vortex.toml time.dt=0.02,0.04 --out failing", folder);
  CAPTURE(failing.out, failing.err);
  CHECK(failing.code == 1);
  CHECK(last_line(failing.out)
            .starts_with("1 of 2 runs failed, 0 missed their checks: time.dt=0.02 failed: "));
  CHECK(fs::exists(folder / "failing/time.dt=0.04/summary.json"));
  CHECK(text_of(folder / "failing/sweep.csv").find("\n0.02,,,,,,\n0.04,2,") != std::string::npos);

  const std::string missing =
      "run vortex.toml time.dt=0.02,0.04 --out missing velocity.method=direct "
      "check.second_moment_max=";
  const auto missed = call(missing + "1e-30", folder);
  CHECK(missed.code == 1);
  CHECK(last_line(missed.out).starts_with("0 of 2 runs failed, 2 missed their checks: "));

  // Every run has its end already; what is asked may change.
  const auto again = call(missing + "1 --resume", folder);
  CAPTURE(again.err);
  CHECK(again.code == 0);
  CHECK(last_line(again.out).starts_with("results in "));
}

namespace {

const std::string two_methods = R"(
accuracy = 0.1
[flow]
reynolds = 20
stream = [1.0, 0.0]
[body]
radius = 0.5
[sph]
rings = 3
[splitting]
children = 5
[time]
end = 0.06
[check]
lift_max = 1
)";

/// The cells of the line that begins so.
std::vector<double> numbers_behind(const std::string& begin, const std::string& csv) {
  std::vector<double> numbers;
  const auto at = csv.find(begin);
  if (at == std::string::npos) return numbers;
  std::istringstream cells(
      csv.substr(at + begin.size(), csv.find('\n', at + 1) - at - begin.size()));
  for (std::string cell; std::getline(cells, cell, ',');) numbers.push_back(std::stod(cell));
  return numbers;
}

}  // namespace

TEST_CASE(
    "methods are swept as any key: each chooses by the accuracy, and reads the others' tables") {
  const SceneFolder folder("cylinder.toml", two_methods);
  const auto outcome = call("run cylinder.toml method=vortex,sph flow.reynolds=20,30", folder);
  CAPTURE(outcome.out, outcome.err);
  CHECK(outcome.code == 0);
  CHECK(outcome.out.find("all") == std::string::npos);  // flows that differ have no order
  const std::string csv = text_of(folder / "runs/cylinder/sweep.csv");
  const auto vortices = numbers_behind("\nvortex,30,", csv), sph = numbers_behind("\nsph,30,", csv);
  REQUIRE(vortices.size() == 6);  // steps, particles, particle_steps, two of seconds, lift_max
  REQUIRE(sph.size() == 6);
  for (const double number : sph) CHECK(number > 0);
  CHECK(sph[1] > vortices[1]);  // its particles fill the box
  for (const char* method : {"vortex", "sph"})
    CHECK(text_of(folder / ("runs/cylinder/method=" + std::string(method) +
                            ",flow.reynolds=30/summary.json"))
              .find("\"method\": \"" + std::string(method) + "\"") != std::string::npos);
  const auto refused = call("run cylinder.toml method=vortex,sph sph.rings=0 --out other", folder);
  CHECK(refused.code == 2);
  CHECK(refused.error_lines() == 1);
  CHECK_FALSE(fs::exists(folder / "other"));
}

TEST_CASE("a sweep that is stopped says where, leaves 1, and goes on from there") {
  const SceneFolder folder("vortex.toml", lone_vortex);
  const auto stopped = interrupted("run vortex.toml time.end=0.08,1000 --out broken", folder,
                                   "broken/time.end=1000/report.csv", 3);
  CAPTURE(stopped.err);
  CHECK(stopped.code == 1);
  CHECK(last_line(stopped.err) == "vortree: the sweep has stopped in run 2 of 2");
  CHECK(text_of(folder / "broken/sweep.csv").find("\n0.08,8,") != std::string::npos);
}

TEST_CASE("runs that would be the same, or in one folder, are refused before anything runs") {
  const TemporaryFolder folder;
  folder.write("vortex.toml", lone_vortex);
  const std::pair<std::string, std::string> rows[] = {
      {"time.dt=0.02,2e-2", "time.dt=2e-2 is the same run as time.dt=0.02\n"},
      {"time.dt=0.02,0.02", "time.dt=0.02 is the same run as time.dt=0.02\n"},
      {"accuracy=0.04,0.02 merging.reach=2 merging.cap=1.1 velocity.tolerance=1e-6",
       "accuracy=0.02 is the same run as accuracy=0.04: all that an accuracy chooses is written\n"},
      {"title=\"a b\",\"a_b\"", "would run in the folder of"},
      {"seed=1,2,3,4,5,6,7,8,9,10 time.dt=" +
           [] {
             std::string values = "0.01";
             for (int k = 0; k < 1000; ++k) values += fmt::format(",{}", 0.02 + 1e-5 * k);
             return values;
           }(),
       "a sweep of more than 10000 runs"}};
  for (const auto& [words, about] : rows) {
    const auto outcome = call("run vortex.toml " + words, folder);
    CAPTURE(words.substr(0, 100), outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.err.find(about) != std::string::npos);
    CHECK_FALSE(fs::exists(folder / "runs"));
  }
}

TEST_CASE("a sweep with a wrong value is refused before anything runs") {
  const TemporaryFolder folder;
  folder.write("vortex.toml", lone_vortex);
  const auto outcome = call("run vortex.toml time.dt=0.02,-1", folder);
  CHECK(outcome.code == 2);
  CHECK(outcome.error_lines() == 1);
  CHECK_FALSE(fs::exists(folder / "runs"));
}
