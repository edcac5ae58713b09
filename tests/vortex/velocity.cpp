#include "vortex/velocity.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "point_sets.hpp"

using namespace vortree;

namespace {

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double wrong = 0, whole = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    wrong += (a[i] - b[i]) * (a[i] - b[i]);
    whole += b[i] * b[i];
  }
  return std::sqrt(wrong / whole);
}

}  // namespace

TEST_CASE("a plan and the direct sum agree on velocities and gradients") {
  test::PointSet set = test::make_points(test::Kind::ringwake, 2000);
  test::Uniform uniform(3);
  for (std::size_t i = 0; i < set.size(); ++i) set.sigma.push_back(0.02 * (1 + uniform()));
  const std::vector<double> x{0.5, 1.5, -0.3}, y{0.2, -0.7, 0.9};
  for (const fmm::Cores cores : {fmm::Cores::mean, fmm::Cores::source}) {
    vortex::Velocities u[2]{vortex::Velocities(set.size()), vortex::Velocities(set.size())};
    vortex::Velocities elsewhere[2]{vortex::Velocities(x.size()), vortex::Velocities(x.size())};
    vortex::Gradients gradient[2]{vortex::Gradients(set.size()), vortex::Gradients(set.size())};
    vortex::velocity_by_plan({.tolerance = 1e-8, .cores = cores})
        ->upon_itself_and(set.blobs(), {x, y}, u[0], gradient[0], elsewhere[0]);
    vortex::velocity_by_direct_sum(cores)->upon_itself_and(set.blobs(), {x, y}, u[1], gradient[1],
                                                           elsewhere[1]);
    CHECK(distance(u[0].u, u[1].u) < 1e-8);
    CHECK(distance(u[0].v, u[1].v) < 1e-8);
    CHECK(distance(elsewhere[0].u, elsewhere[1].u) < 1e-8);
    CHECK(distance(elsewhere[0].v, elsewhere[1].v) < 1e-8);
    CHECK(distance(gradient[0].ux, gradient[1].ux) < 1e-6);
    CHECK(distance(gradient[0].uy, gradient[1].uy) < 1e-6);
    CHECK(distance(gradient[0].vx, gradient[1].vx) < 1e-6);
  }
}
