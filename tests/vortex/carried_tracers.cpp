#include "flow/paths/carried_tracers.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>

#include "body/shapes/circle.hpp"
#include "body/shapes/ellipse.hpp"
#include "vortex/solver.hpp"

using namespace vortree;

namespace {

/// A vortex that neither decays nor moves, away from the origin.
vortex::VortexSolver steady_vortex(double dt) {
  vortex::Setup setup{.problem = {.flow = {{}, 0},
                                  .dt = dt,
                                  .sigma_0 = 0.2,
                                  .splitting = {},
                                  .merging = {},
                                  .sums = {.tolerance = 1e-10}},
                      .origin = {{2, 1}}};
  setup.blobs = vortex::Blobs({0}, {0}, {1}, {0.2});
  return vortex::VortexSolver(std::move(setup));
}

/// How far a tracer at radius 0.3 is from where the vortex brings it in a time of 2.
double error(double dt) {
  vortex::VortexSolver solver = steady_vortex(dt);
  flow::CarriedTracers tracers({{.line = std::array{2.3, 1.0, 2.3, 1.0}}}, {});
  tracers.release(-1, 0);
  while (solver.time() < 2 - dt / 2) {
    tracers.sample(solver);
    solver.step([](std::string_view) {});
    tracers.carry(dt);
  }
  const double rate = (1 - std::exp(-0.09 / 0.04)) / (2 * std::acos(-1.0) * 0.09);
  return std::hypot(tracers.x()[0] - 2 - 0.3 * std::cos(2 * rate),
                    tracers.y()[0] - 1 - 0.3 * std::sin(2 * rate));
}

}  // namespace

TEST_CASE("a tracer of a steady vortex stays on its circle, to second order in the step") {
  const double coarse = error(0.04), fine = error(0.02);
  CHECK(fine < 1e-3);
  CHECK(std::log2(coarse / fine) == Approx(2).margin(0.15));
}

TEST_CASE("tracers begin along their line or around the body, when they are due") {
  const body::Body circle{body::circle({}, 0.5), {1, 2}, {}, 64};
  flow::CarriedTracers tracers({{.around = 0.1, .count = 8, .every = 0.5},
                                {.line = std::array{0.0, 0.0, 3.0, 6.0}, .count = 4, .from = 0.25}},
                               {circle});
  tracers.release(-1, 0);
  REQUIRE(tracers.size() == 8);
  for (std::size_t k = 0; k < 8; ++k)
    CHECK(std::hypot(tracers.x()[k] - 1, tracers.y()[k] - 2) == Approx(0.6));
  CHECK(std::hypot(tracers.x()[1] - tracers.x()[0], tracers.y()[1] - tracers.y()[0]) ==
        Approx(2 * 0.6 * std::sin(std::acos(-1.0) / 8)));
  tracers.release(0, 0.2);
  CHECK(tracers.size() == 8);
  tracers.release(0.2, 0.3);
  REQUIRE(tracers.size() == 12);
  CHECK(tracers.x()[9] == Approx(1));
  CHECK(tracers.y()[11] == Approx(6));
  tracers.release(0.3, 5 * 0.1);
  CHECK(tracers.size() == 20);
  tracers.release(0.5, 2.2);  // one release in a step
  CHECK(tracers.size() == 28);
}

TEST_CASE("around a body that turns tracers begin around where it has turned to") {
  const std::shared_ptr<const body::Shape> shape = body::ellipse({}, 0.5, 0.2, 0);
  const body::Body turning{shape, {1, 2}, {.spin = {0.8}}, 64};
  flow::CarriedTracers tracers({{.around = 0.1, .count = 16, .from = 1.5}}, {turning});
  tracers.release(1.4, 1.5);
  REQUIRE(tracers.size() == 16);
  const double angle = turning.motion.at(1.5).angle;
  CHECK(angle == Approx(1.2));
  for (std::size_t k = 0; k < 16; ++k) {
    const double x = tracers.x()[k] - 1, y = tracers.y()[k] - 2;
    const Vec2 in_axes{std::cos(angle) * x + std::sin(angle) * y,
                       std::cos(angle) * y - std::sin(angle) * x};
    CHECK(shape->nearest(in_axes).distance == Approx(0.1));
  }
}
