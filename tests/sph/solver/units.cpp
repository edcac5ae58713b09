#include <catch2/catch.hpp>
#include <cmath>

#include "sph/solver/scene.hpp"

using namespace vortree;
using namespace vortree::sph::test;

namespace {

/// The drag coefficient, by pressure and friction, after three steps at Re = 20, in a unit of
/// length and one of speed.
double drag(double length, double speed, const std::string& outside) {
  SphScene scene;
  scene.of.flow.stream = {speed, 0};
  scene.of.flow.nu = 0.05 * length * speed;
  scene.of.body = vortree::test::circle(0.5 * length);
  scene.of.time.end = length / speed;
  scene.set("spacing", 0.1 * length);
  if (outside == "plunge") {
    scene.of.flow.stream = {0, 0};
    scene.of.plunge = body::PlungeSettings{
        .amplitude = 0.5 * length, .frequency = speed / (3.14159 * length), .direction = {1, 0}};
  }
  const auto solver = scene.step(0.03 * length / speed).choose().begin();
  for (int step = 0; step < 3; ++step) solver->step([](auto) {});
  const flow::Force force = solver->force().value();
  return (force.pressure.x + force.friction.x) / (speed * speed * length);
}

}  // namespace

TEST_CASE("a flow is the same in any units of length and time") {
  for (const std::string outside : {"free", "plunge"}) {
    const double usual = drag(1, 1, outside);
    CAPTURE(outside, usual);
    CHECK(std::abs(usual) > 0.1);
    // Systems are solved to 1e-5; which iteration is the last may hang on round-off.
    for (const auto& [length, speed] : {std::pair{1e-6, 1.0}, {1e6, 1.0}, {1.0, 1e-4}, {1e-3, 1e5}})
      CHECK(drag(length, speed, outside) == Approx(usual).epsilon(1e-3));
  }
}
