#include "sph/motion/momentum.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "sph/boundary/outer_box.hpp"
#include "tree/clouds.hpp"

using namespace vortree;
using namespace vortree::sph;

namespace {

constexpr double s = 0.1, dt = 0.01, ratio = 0.8;

/// A box of particles without a body, its outlet on the right.
Cloud box_of_fluid() {
  Cloud cloud;
  std::int32_t number = 0;
  for (const BoundaryNode& node : box_nodes({{-1, -1}, {1, 1}}, s))
    cloud.add(node, node.normal.x < 0 ? ParticleKind::outlet : ParticleKind::outer, number++);
  vortree::test::Chance chance(5);
  const auto jitter = [&] { return 0.2 * s * (chance.real() - 0.5); };
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      cloud.add({-1 + (i + 0.5) * s + jitter(), -1 + (j + 0.5) * s + jitter()}, s,
                ParticleKind::fluid);
  return cloud;
}

}  // namespace

TEST_CASE("a uniform stream as seen from a box that plunges stays uniform, to the tolerance") {
  const double t = 0.3;
  for (const Vec2 amplitude : {Vec2{0, 0.1}, Vec2{0.05, 0.1}}) {
    const Ambient ambient{.nu = 0.01, .steady = {1, 0}, .motion = {.plunge = {amplitude, 0.7}}};
    const Vec2 before = ambient.stream(t - dt / ratio), now = ambient.stream(t),
               later = ambient.stream(t + dt);
    Cloud cloud = box_of_fluid();
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      cloud.u[i] = now.x, cloud.v[i] = now.y;
      cloud.u_before[i] = before.x, cloud.v_before[i] = before.y;
    }
    const OperatorOptions options;
    Stencils stencils;
    stencils.renew(cloud, options);
    Momentum momentum;
    const std::vector<double> no_wall;
    const TimeStep step{dt, ratio};
    momentum.solve(cloud, stencils, options,
                   {.step = step,
                    .later = t + dt,
                    .ambient = ambient,
                    .wall_vorticity = no_wall,
                    .tolerance = 1e-11},
                   [](auto) {});
    // The fluid is driven by a pressure that is linear: fits are exact.
    const Vec2 rate = 1 / dt * (step.b0() * later - step.b1() * now + step.b2() * before);
    double off = 0, pressure = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const Vec2 d = cloud.velocity(i) - later;
      off = std::max(off, std::sqrt(dot(d, d)));
      pressure = std::max(
          pressure, std::abs(cloud.p[i] - cloud.p[0] - dot(-1 * rate, cloud.at(i) - cloud.at(0))));
    }
    CHECK(std::sqrt(dot(later - now, later - now)) > 1e-3);
    CHECK(off < 1e-6);  // the viscous step is solved to 1e-7
    CHECK(pressure < 1e-6 * std::sqrt(dot(rate, rate)));
  }
}
