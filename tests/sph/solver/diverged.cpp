#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "sph/solver/scene.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

SphSetup small_setup(double tolerance) {
  SphCase scene;
  static_cast<flow::Case&>(scene) = small_scene().of;
  scene.sph.spacing = 0.1, scene.sph.levels = 2, scene.sph.zone = 0.5, scene.sph.reach = 2.8;
  scene.sph.box = {-1.8, -1.7, 2.2, 1.7};
  scene.sph.tolerance = tolerance;
  return setup_of(scene);
}

/// The flow with a number of its columns changed.
std::unique_ptr<flow::Solver> spoiled(const char* name, double value) {
  auto solver = small_flow();
  advance(*solver, 1);
  flow::State state;
  solver->save(state);
  flow::Columns columns = solver->columns();
  for (flow::Column& column : columns)
    if (column.name == name)
      for (std::size_t i = 0; i < column.values.size(); i += 7) column.values[i] = value;
  solver->restore(1, columns, state);
  return solver;
}

}  // namespace

TEST_CASE("a pressure that is not found ends the flow with a reason, as it was before the step") {
  // Nothing is that exact in doubles.
  SphSolver solver(small_setup(1e-30));
  const Told before(solver);
  for (int again = 0; again < 2; ++again) {
    try {
      solver.step([](auto) {});
      FAIL("it went on");
    } catch (const flow::Diverged& reason) {
      CHECK_THAT(reason.what(), Catch::Contains("pressure is not found"));
    }
    check_same(Told(solver), before);
    CHECK(solver.steps() == 0);
  }
}

TEST_CASE("velocities that are no numbers, or absurd, end the flow with a reason") {
  for (const double value : {1e30, 1e300, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    const auto solver = spoiled("u", value);
    CAPTURE(value);
    CHECK_THROWS_AS(advance(*solver, 1), flow::Diverged);
    CHECK(solver->steps() == 1);
  }
}

TEST_CASE("why a flow has ended is told in numbers that people read") {
  const auto solver = spoiled("u", 1234.5678901);
  CHECK_THROWS_WITH(advance(*solver, 1),
                    Catch::Contains("a particle moves 1.23e+03 times as fast"));
}

TEST_CASE(
    "past a body fits of degree 4 and pair sums hold in short steps, in which nothing is damped") {
  SphScene scene;
  scene.of.flow.nu = 0.02;
  scene.set("spacing", 0.2).set("levels", 1).set("box", std::array{-2.8, -2.6, 3.4, 2.6});
  SECTION("degree 4") {
    scene.set("degree", 4);
  }
  SECTION("pair sums") {
    scene.set("operators", OperatorKind::pair_sums);
  }
  const auto solver = scene.step(0.006).choose().begin();
  advance(*solver, 120);  // rows beside the sides of the box grew, and broke the first at step 91
  for (const flow::Column& column : solver->columns())
    if (column.name == "u")
      for (const double u : column.values) REQUIRE(std::abs(u) < 3);  // potential flow has 2
}
