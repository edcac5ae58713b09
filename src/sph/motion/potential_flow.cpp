#include "sph/motion/potential_flow.hpp"

#include <numbers>
#include <vector>

#include "sph/motion/pressure_system.hpp"
#include "sph/motion/tuning.hpp"
#include "sph/operators/boundary_fits.hpp"
#include "sph/operators/derivatives.hpp"

namespace vortree::sph {
namespace {

/// The velocity around a vortex, d away from it.
Vec2 around(double gamma, Vec2 d) {
  return gamma / (2 * std::numbers::pi * dot(d, d)) * Vec2{-d.y, d.x};
}

void add_around(Cloud& cloud, double gamma, Vec2 centre) {
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec2 added = around(gamma, cloud.at(i) - centre);
    cloud.u[i] += added.x, cloud.v[i] += added.y;
  }
}

/// That of the sheets on walls.
Vec2 by_sheets(const Cloud& cloud, Vec2 at) {
  Vec2 sum{};
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.kind[i] != ParticleKind::wall) continue;
    const Vec2 n = cloud.normal(i);
    const double gamma = dot(cloud.velocity(i), {-n.y, n.x}) * cloud.spacing[i];
    sum += around(gamma, at - cloud.at(i));
  }
  return sum;
}

/// That around bodies of these circulations.
Vec2 around(const StandingBodies& bodies, const std::vector<double>& circulations, Vec2 at) {
  Vec2 sum = around(circulations[0], at - bodies[0].centre);
  for (std::size_t k = 1; k < bodies.size(); ++k)
    sum += around(circulations[k], at - bodies[k].centre);
  return sum;
}

}  // namespace

void start_potential_flow(Cloud& cloud, const Stencils& stencils, const OperatorOptions& options,
                          const Ambient& ambient, const StandingBodies& bodies, bool unbounded,
                          double circulation) {
  const std::size_t n = cloud.size();
  const Vec2 stream = ambient.stream(0);
  BoundaryFits fits;
  fits.renew(cloud, stencils, options);
  PressureSystem system;
  system.renew(cloud, stencils, fits, false);
  const std::vector<double> shares = bodies.shared(circulation);
  for (std::size_t k = 0; k < bodies.size(); ++k) add_around(cloud, shares[k], bodies[k].centre);
  const std::vector<double> u = cloud.u, v = cloud.v;
  std::vector<double> none(n, 0), slope(n, 0), phi(n, 0), x(n), y(n);
  for (int turn = 0; turn < (unbounded ? 4 : 1); ++turn) {
    for (const BoundaryFits::Node& node : fits.nodes()) {
      const auto i = static_cast<std::size_t>(node.particle);
      const Vec2 at = cloud.at(i), carried{u[i], v[i]};
      const bool wall = cloud.kind[i] == ParticleKind::wall;
      const Vec2 added = wall        ? bodies.wall_velocity(cloud.place[i], at) - stream - carried
                         : unbounded ? by_sheets(cloud, at) - around(bodies, shares, at)
                                     : -1 * carried;
      slope[i] = dot(cloud.normal(i), added);
    }
    system.solve(none, slope, phi, start_tolerance);
    find_gradient(phi, stencils, x, y);
    for (std::size_t i = 0; i < n; ++i) {
      cloud.u[i] = u[i] + stream.x + x[i];
      cloud.v[i] = v[i] + stream.y + y[i];
    }
  }
  cloud.u_before = cloud.u, cloud.v_before = cloud.v;
}

}  // namespace vortree::sph
