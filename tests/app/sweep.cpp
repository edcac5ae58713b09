#include "app/sweep.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "app/convergence.hpp"
#include "app/program.hpp"
#include "io/input_error.hpp"

using namespace vortree;
using namespace vortree::test;
using app::Axis;

namespace {

const std::string lone_vortex = R"(
[flow]
nu = 1e-3
[cores]
sigma_0 = 0.06
sigma_max = 1
[initial]
kind = "lamb_oseen"
circulation = 1.0
core = 0.2
[merging]
tolerance = 0
[time]
dt = 0.01
end = 0.08
[check]
second_moment_max = 1
)";

}  // namespace

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
  const auto p = app::orders(h, e);
  CHECK(std::isnan(p[0]));
  CHECK(p[1] == Approx(2.5));
  CHECK(p[2] == Approx(2.5));
  CHECK(app::fitted_order(h, e) == Approx(2.5));
  e[1] = INFINITY;
  CHECK(std::isnan(app::orders(h, e)[1]));
  CHECK(app::fitted_order(h, e) == Approx(2.5));
  CHECK(std::isnan(app::fitted_order(std::vector<double>{1, 1}, std::vector<double>{1, 2})));
}

TEST_CASE("a sweep runs the list into folders, and measures the order of the time step") {
  const TemporaryFolder folder;
  setenv("VORTREE_SHARE", folder.path().c_str(), 1);  // no figures
  folder.write("vortex.toml", lone_vortex);
  const auto outcome = call(
      "run vortex.toml time.scheme=rk4,rk2 time.dt=0.02,0.01,0.005 velocity.method=direct", folder);
  unsetenv("VORTREE_SHARE");
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
  CHECK(csv.find("\ntime.scheme,time.dt,steps,blobs,particle_steps,seconds,second_moment_max\n") !=
        std::string::npos);
  CHECK(csv.find("\nrk2,0.01,8,") != std::string::npos);
}

TEST_CASE("a sweep with a wrong value is refused before anything runs") {
  const TemporaryFolder folder;
  folder.write("vortex.toml", lone_vortex);
  const auto outcome = call("run vortex.toml time.dt=0.02,-1", folder);
  CHECK(outcome.code == 2);
  CHECK(outcome.error_lines() == 1);
  CHECK_FALSE(fs::exists(folder / "runs"));
}
