#include <omp.h>

#include <catch2/catch.hpp>

#include "sph/solver/scene.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

/// A solver of a scene, gone on from where another one is.
std::unique_ptr<flow::Solver> resumed(const SphScene& scene, const flow::Solver& from) {
  flow::State state;
  from.save(state);
  auto solver = scene.begin();
  solver->restore(from.steps(), from.columns(), state);
  return solver;
}

SphScene choose(SphScene scene) {
  scene.choose();
  return scene;
}

}  // namespace

TEST_CASE("a flow that is resumed goes on to the same bits, from any step") {
  const SphScene scene = choose(small_scene());
  const auto whole = scene.begin();
  for (int step = 0; step < 5; ++step) {
    const auto half = resumed(scene, *whole);
    CAPTURE(step);
    check_same(Told(*half), Told(*whole));
    advance(*half, 1), advance(*whole, 1);
    check_same(Told(*half), Told(*whole));
  }
}

TEST_CASE("flows with degree 4, in a box, with a body that plunges or turns are resumed, too") {
  SphScene scene = small_scene();
  SECTION("degree 4") {
    scene.set("degree", 4);
  }
  SECTION("box") {
    scene.set("outside", Outside::box);
  }
  SECTION("turns") {
    scene.of.motion = body::MotionSettings{1};
  }
  SECTION("plunges") {
    scene.of.plunge = body::PlungeSettings{0.1, 0.5, {0, 1}};
    scene.of.flow.stream = {0, 0};
  }
  SECTION("plunges across a stream") {
    scene.of.plunge = body::PlungeSettings{0.1, 0.5, {0, 1}};
  }
  SECTION("begins with a vortex") {
    scene.of.initial.emplace();
    scene.of.initial->circulation = 0.5, scene.of.initial->core = 0.3;
    scene.of.initial->centre = {1, 0.7};
  }
  SECTION("past a thin body") {
    scene.of.body = vortree::test::foil(1, 5);
    scene.set("spacing", 0.025).set("zone", 0.1);
  }
  SECTION("along y") {
    scene.of.flow.stream = {0, -1};
  }
  scene.choose();
  const auto whole = scene.begin();
  advance(*whole, 2);
  const auto half = resumed(scene, *whole);
  check_same(Told(*half), Told(*whole));
  advance(*half, 2), advance(*whole, 2);
  check_same(Told(*half), Told(*whole));
}

TEST_CASE("what a solver did before it was told to go on from a frame does not matter") {
  const SphScene scene = choose(small_scene());
  const auto whole = scene.begin(), used = scene.begin();
  advance(*whole, 2), advance(*used, 4);
  flow::State state;
  whole->save(state);
  used->restore(whole->steps(), whole->columns(), state);
  check_same(Told(*used), Told(*whole));
  advance(*used, 1), advance(*whole, 1);
  check_same(Told(*used), Told(*whole));
}

TEST_CASE("nothing that is saved can be missed") {
  const SphScene scene = choose(small_scene());
  const auto whole = scene.begin();
  advance(*whole, 1);
  flow::State state;
  whole->save(state);
  CHECK(state.size() > 10);
  for (const auto& [name, values] : state) {
    CAPTURE(name);
    flow::State lacking = state;
    lacking.erase(name);
    const auto solver = scene.begin();
    CHECK_THROWS_AS(solver->restore(1, whole->columns(), lacking), std::out_of_range);
  }
  const auto solver = scene.begin();
  CHECK_THROWS_AS(solver->restore(1, {}, state), std::out_of_range);
}

TEST_CASE("a flow has the same bits for one thread and for two") {
  const int before = omp_get_max_threads();
  std::vector<Told> told;
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    const auto solver = small_flow();
    advance(*solver, 4);
    told.emplace_back(*solver);
  }
  omp_set_num_threads(before);
  check_same(told[0], told[1]);
}

TEST_CASE("two flows of one scene have the same bits") {
  const auto a = small_flow(), b = small_flow();
  advance(*a, 2), advance(*b, 2);
  check_same(Told(*a), Told(*b));
}
