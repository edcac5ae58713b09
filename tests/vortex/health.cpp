#include "vortex/health.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "body/shape.hpp"
#include "body/shapes/circle.hpp"

using namespace vortree;
using Catch::Matchers::Contains;

namespace {

// U = D = 1, steps of 0.05, sixteen panels.
vortex::Setup cylinder() {
  vortex::Setup made{.problem = {.flow = {{1, 0}, 0.01},
                                 .dt = 0.05,
                                 .sigma_0 = 0.05,
                                 .splitting = {.sigma_max = 0.1},
                                 .merging = {.tolerance = 0.1, .sigma_max = 0.1},
                                 .sums = {}},
                     .scales = {.body = true}};
  made.wall = std::make_shared<vortex::MovingWall>(body::circle({}, 0.5), 16);
  return made;
}

// A free vortex.
vortex::Setup free_space() {
  return {.problem = {.flow = {{}, 1e-3},
                      .dt = 0.02,
                      .sigma_0 = 0.04,
                      .splitting = {.sigma_max = 0.05},
                      .merging = {.tolerance = 0.02, .sigma_max = 0.05},
                      .sums = {}}};
}

vortex::Blobs blobs(std::size_t n, double gamma = 1e-6) {
  vortex::Blobs made;
  for (std::size_t k = 0; k < n; ++k) made.append({1, 0.001 * k}, k % 2 ? gamma : -gamma, 0.05);
  return made;
}

}  // namespace

TEST_CASE("blobs that are finite, few and weak are no reason to end") {
  CHECK(vortex::broken(blobs(100), cylinder(), 5) == "");
  CHECK(vortex::broken(blobs(0), cylinder(), 0.05) == "");
}

TEST_CASE("a number that is not finite is a reason, in any column, and names its blob") {
  const auto flow = cylinder();
  for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY)})
    for (auto column :
         {&vortex::Blobs::x, &vortex::Blobs::y, &vortex::Blobs::gamma, &vortex::Blobs::sigma,
          &vortex::Blobs::xx, &vortex::Blobs::xy}) {
      auto some = blobs(10);
      (some.*column)[7] = bad;
      CHECK(vortex::broken(some, flow, 5) == "blob 7 of 10 is no longer finite");
    }
}

TEST_CASE(
    "a step may leave three times the blobs, or 20 000, and more for each panel at the start") {
  const auto flow = cylinder();
  const auto most = [&](const std::vector<std::size_t>& counts, double time) {
    vortex::Growth growth;
    for (const std::size_t count : counts) growth.add(count);
    return growth.most(time, flow);
  };
  CHECK(most({6'000}, 5) == 20'000);
  CHECK(most({8'000}, 5) == 24'000);
  CHECK(most({16}, 0.05) == 150'000);
  CHECK(most({6'000}, 0.1) == 20'000);
  CHECK(most({7'000}, 0.1) == 21'000 + 16 * 100);
  CHECK(most({9'000'000}, 5) == std::min<std::size_t>(20'000'000, flow.held_blobs));
}

TEST_CASE("the sheet of the start may split five times before it merges, which 597 a panel are") {
  auto flow = cylinder();
  flow.wall = std::make_shared<vortex::MovingWall>(body::circle({}, 0.5), 500);
  vortex::Growth growth;
  growth.add(500);
  CHECK(growth.most(0.05, flow) == 500 * 1000);
  CHECK(growth.most(0.1, flow) == 500 * 100 + 3 * 500);
  flow.held_blobs = 400'000;
  CHECK(growth.most(0.05, flow) == 400'000);
}

TEST_CASE("what is said to keep blobs fewer is what does") {
  auto flow = cylinder();
  const auto said = [&] { return vortex::multiplied(200'000, 8'000, flow); };
  CHECK_THAT(said(), Contains("more body.panels or smaller time.dt"));
  flow.problem.splitting.alpha = 0.87;
  CHECK_THAT(said(), Contains("smaller splitting.alpha, larger cores.sigma_max or merging.cap"));
  flow.problem.merging.sigma_max = 0.15;
  CHECK_THAT(said(), Contains("more body.panels"));
  flow.splits_endlessly = true;
  CHECK_THAT(said(), Contains("larger cores.sigma_max or smaller time.dt"));
}

TEST_CASE("from 5000 blobs on five steps may leave three times as many, too") {
  const auto flow = cylinder();
  vortex::Growth growth;
  for (const std::size_t count : {2'000, 2'600, 3'400, 4'400, 5'700}) growth.add(count);
  CHECK(growth.most(5, flow) == 20'000);  // too little is known
  growth.add(5'900);
  CHECK(growth.most(5, flow) == 6'000);
  CHECK(growth.most(0.55, flow) == 20'000);  // the first steps make many of the first sheet
  growth.add(6'000);
  CHECK(growth.most(5, flow) == 7'800);
}

TEST_CASE("a tolerance that lets fewer merge may leave more blobs") {
  auto flow = cylinder();
  CHECK(flow.crowding == 1);
  flow.crowding = 10;
  vortex::Growth growth;
  growth.add(6'000);
  CHECK(growth.most(5, flow) == 200'000);
  CHECK(growth.most(0.05, flow) == 200'000);
  for (int k = 0; k < 5; ++k) growth.add(7'000);
  CHECK(growth.most(5, flow) == 50'000);
}

TEST_CASE("in free space all may split at once, and twice, unless children are too wide to merge") {
  const auto most = [&](bool too_wide) {
    vortex::Setup flow = free_space();
    flow.splits_endlessly = too_wide;
    vortex::Growth growth;
    for (const std::size_t count : {2'000, 2'000, 2'000, 8'000, 8'000, 8'000}) growth.add(count);
    CHECK_THAT(vortex::multiplied(200'000, 8'000, flow),
               Contains(too_wide ? "larger cores.sigma_max" : "larger merging.tolerance"));
    return growth.most(0.2, flow);
  };
  CHECK(most(false) == 16 * 8'000);
  CHECK(most(true) == 6'000);
}

TEST_CASE("blobs that never merge, as the scene has it, may all have children in a step") {
  auto flow = cylinder();
  flow.problem.merging.tolerance = 0;
  vortex::Growth growth;
  growth.add(10'000);
  CHECK(growth.most(5, flow) == 40'000);
  CHECK_THAT(vortex::multiplied(50'000, 10'000, flow), Contains("they split and never merge"));
  flow.held_blobs = 30'000;
  CHECK(growth.most(5, flow) == 30'000);
  CHECK_THAT(vortex::multiplied(50'000, 10'000, flow),
             Contains("the machine's memory holds 30000"));
}

TEST_CASE("more vorticity than a wake can have is a reason beside a body, more of it later on") {
  const auto flow = cylinder();
  CHECK(vortex::broken(blobs(100, 0.99), flow, 5) == "");
  CHECK_THAT(vortex::broken(blobs(100, 1.01), flow, 5), Contains("grown to 101 U D"));
  CHECK(vortex::broken(blobs(100, 1.99), flow, 20) == "");
  CHECK_THAT(vortex::broken(blobs(100, 2.01), flow, 20), Contains("grown to 201 U D"));
}
