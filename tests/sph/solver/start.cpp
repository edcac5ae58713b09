#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body/shapes/circle.hpp"
#include "sph/solver/scene.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

TEST_CASE("the start is its own mirror image in the stream's line, to what its particles are off") {
  const auto solver = small_flow();
  const flow::Columns all = solver->columns();
  const auto &x = flow::column(all, "x"), &y = flow::column(all, "y"), &u = flow::column(all, "u"),
             &v = flow::column(all, "v"), &s = flow::column(all, "spacing"),
             &kind = flow::column(all, "kind");
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (kind[i] == 0) continue;  // free ones have each been moved a little
    std::size_t mirror = 0;
    double least = 1e9;
    for (std::size_t j = 0; j < x.size(); ++j) {
      const double r = std::hypot(x[j] - x[i], y[j] + y[i]);
      if (r < least) least = r, mirror = j;
    }
    REQUIRE(least < 1e-9);  // arcs of rings are found to 2^-30 of a place
    CHECK(kind[mirror] == kind[i]);
    CHECK(s[mirror] == Approx(s[i]).epsilon(1e-12));
    // Potential flow at this spacing is 0.085 off; a tenth of that hangs on where particles stand.
    CHECK(u[mirror] == Approx(u[i]).margin(0.0085));
    CHECK(v[mirror] == Approx(-v[i]).margin(0.0085));
  }
}

TEST_CASE("particles of the start stand in the box, outside the rings, as finely as is wanted") {
  const auto solver = small_flow();
  const Cloud& cloud = dynamic_cast<const SphSolver&>(*solver).cloud();
  const std::shared_ptr<const body::Shape> circle = body::circle({}, 0.5);
  const WantedSpacing wanted(circle, 0.1, 2, 0.5, 2);
  const OuterBox box{{-1.8, -1.7}, {2.2, 1.7}};
  std::size_t counts[5] = {};
  double volume = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ++counts[static_cast<int>(cloud.kind[i])];
    if (cloud.inside(i)) volume += cloud.volume(i);
    if (!cloud.free(i)) continue;
    CHECK(box.depth(cloud.at(i)) > 0.2 * cloud.spacing[i]);
    CHECK(circle->distance(cloud.at(i)) > 0.42);
    const double share = cloud.spacing[i] / wanted.at(cloud.at(i));
    CHECK(share < 1.5);
    CHECK(share > 0.55);
  }
  CHECK(counts[2] == 31);                 // pi/0.1
  CHECK(counts[1] == 37 + 44 + 50 + 56);  // rings, 2 pi each longer than the one before
  CHECK(counts[3] + counts[4] == 2 * (20 + 17));
  CHECK(counts[4] == 18);  // the right side with its corners
  CHECK(volume == Approx(4 * 3.4 - std::numbers::pi / 4).epsilon(0.03));
}

TEST_CASE("a flow that has begun tells finite numbers of all columns and measures") {
  const auto solver = small_flow();
  CHECK(solver->steps() == 0);
  CHECK(solver->time() == 0);
  CHECK(solver->particle() == "particle");
  for (const int steps : {0, 3}) {
    advance(*solver, steps);
    CHECK(flow::not_finite(solver->columns(), "particle").empty());
    CHECK(solver->particles() == flow::column(solver->columns(), "x").size());
    for (const flow::Measure& one : solver->measures()) {
      CAPTURE(one.name);
      CHECK(std::isfinite(one.value));
    }
    CHECK(solver->measures().front().value == static_cast<double>(solver->particles()));
  }
  CHECK(solver->time() == Approx(0.15).epsilon(1e-14));
  CHECK(solver->frame_rows().size() == 31 * solver->frame_table().columns.size());
  // Half a spacing along the sides belongs to their nodes.
  CHECK(flow::measured(solver->measures(), "volume") == Approx(1).margin(0.12));
  CHECK(flow::measured(solver->measures(), "least_neighbors") >= 4);
  CHECK(solver->drift() < 0.1);
}

TEST_CASE("a step tells the phases that were named, and then output") {
  const auto solver = small_flow();
  std::vector<std::string> told;
  solver->step([&](std::string_view phase) { told.emplace_back(phase); });
  const std::vector<std::string> named = solver->phases();
  REQUIRE(told.size() > named.size());
  CHECK(std::vector(told.begin(), told.begin() + static_cast<long>(named.size())) == named);
  CHECK(told.back() == "output");
}

TEST_CASE("a flow looks the same wherever its body stands") {
  SphScene moved = small_scene();
  moved.of.body->centre = {16, -8};  // powers of two, to keep the bits of places
  moved.set("box", std::array{16 - 1.8, -8 - 1.7, 16 + 2.2, -8 + 1.7});
  const auto there = moved.choose().begin(), here = small_flow();
  const flow::Columns a = here->columns(), b = there->columns();
  REQUIRE(here->particles() == there->particles());
  const std::vector<double> x{-3, 0, 0.3, 1, 5}, y{0, 0, 0.8, -1, 2};
  std::vector<double> moved_x = x, moved_y = y;
  for (double& one : moved_x) one += 16;
  for (double& one : moved_y) one -= 8;
  const flow::Samples near = here->sample({x, y}), far = there->sample({moved_x, moved_y});
  for (std::size_t k = 0; k < x.size(); ++k) {
    CHECK(far.u[k] == Approx(near.u[k]).margin(1e-4));
    CHECK(far.v[k] == Approx(near.v[k]).margin(1e-4));
  }
}

TEST_CASE("samples are 0 in the body, those of particles around it, and of the far field beyond") {
  const auto solver = small_flow();
  const std::vector<double> x{0, 0.3, 0, 1.5, 8, -6}, y{0, 0.1, 1, 0.8, 1, -5};
  const flow::Samples found = solver->sample({x, y});
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(found.u[k] == 0);
    CHECK(found.v[k] == 0);
    CHECK(found.omega[k] == 0);
  }
  for (std::size_t k = 2; k < x.size(); ++k) {
    const double r2 = x[k] * x[k] + y[k] * y[k], c = 0.25 / (r2 * r2);
    CHECK(found.u[k] == Approx(1 - c * (x[k] * x[k] - y[k] * y[k])).margin(0.03));
    CHECK(found.v[k] == Approx(-2 * c * x[k] * y[k]).margin(0.03));
  }
  CHECK(found.omega[4] == 0);
}

TEST_CASE("a flow past a circle that turns has no circulation from the start on") {
  SphScene scene = small_scene();
  scene.of.motion = body::MotionSettings{2};
  const auto solver = scene.choose().begin();
  // That of the body alone is 2 Omega A = pi; none goes to infinity.
  CHECK(std::abs(flow::measured(solver->measures(), "circulation")) < 1e-4);
  advance(*solver, 3);
  // A layer of sqrt(nu t) = 0.05 is half a spacing thin in the first step.
  CHECK(solver->drift() < 0.1 * std::numbers::pi);
  CHECK(std::abs(flow::measured(solver->measures(), "circulation")) < 0.1);
}

TEST_CASE("short steps of the start grow until a step is taken as a whole") {
  const auto solver = small_flow();
  const auto last = [&] {
    flow::State state;
    solver->save(state);
    return flow::saved_number(state, "last_dt");
  };
  double before = 0;
  for (int step = 0; step < 5; ++step) {
    advance(*solver, 1);
    CHECK(last() >= before * (1 - 1e-12));
    before = last();
  }
  CHECK(last() == Approx(0.05).epsilon(1e-12));
}
