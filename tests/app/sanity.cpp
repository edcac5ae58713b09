#include "app/sanity.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "io/scene.hpp"

using namespace vortree;
using Catch::Matchers::Contains;

namespace {

// U = D = 1, steps of 0.05.
app::FlowCase cylinder() {
  return app::flow_case(io::parse_scene(
      "[flow]\nnu = 0.01\nstream = [1.0, 0.0]\n[body]\nradius = 0.5\npanels = 16\n[cores]\n"
      "sigma_0 = 0.05\nsigma_max = 0.1\n[time]\ndt = 0.05\nend = 10\n",
      "cylinder.toml"));
}

vortex::Blobs blobs(std::size_t n, double gamma = 1e-6) {
  vortex::Blobs made;
  for (std::size_t k = 0; k < n; ++k) made.append({1, 0.001 * k}, k % 2 ? gamma : -gamma, 0.05);
  return made;
}

}  // namespace

TEST_CASE("blobs that are finite, few and weak are no reason to end") {
  CHECK(app::broken(blobs(100), 90, cylinder(), 5) == "");
  CHECK(app::broken(blobs(0), 0, cylinder(), 0.05) == "");
  CHECK(app::broken(blobs(19'000), 1, cylinder(), 5) == "");
}

TEST_CASE("a number that is not finite is a reason, in any column, and names its blob") {
  const auto flow = cylinder();
  for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY)})
    for (auto column :
         {&vortex::Blobs::x, &vortex::Blobs::y, &vortex::Blobs::gamma, &vortex::Blobs::sigma}) {
      auto some = blobs(10);
      (some.*column)[7] = bad;
      CHECK(app::broken(some, 10, flow, 5) == "blob 7 of 10 is no longer finite");
    }
}

TEST_CASE(
    "blobs that multiply threefold in a step are a reason from 20 000 on, later at the start") {
  const auto flow = cylinder();
  CHECK_THAT(app::broken(blobs(21'000), 6'000, flow, 5), Contains("they multiply faster"));
  CHECK(app::broken(blobs(21'000), 8'000, flow, 5) == "");
  CHECK(app::broken(blobs(21'000), 16, flow, 0.05) == "");
  CHECK_THAT(app::broken(blobs(101'000), 16, flow, 0.05), Contains("they multiply faster"));
}

TEST_CASE("more vorticity than a wake can have is a reason beside a body, more of it later on") {
  const auto flow = cylinder();
  CHECK(app::broken(blobs(100, 0.99), 100, flow, 5) == "");
  CHECK_THAT(app::broken(blobs(100, 1.01), 100, flow, 5), Contains("grown to 101 U D"));
  CHECK(app::broken(blobs(100, 1.99), 100, flow, 20) == "");
  CHECK_THAT(app::broken(blobs(100, 2.01), 100, flow, 20), Contains("grown to 201 U D"));
}
