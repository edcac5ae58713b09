#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sph/boundary/biot_savart.hpp"
#include "sph/boundary/standing_bodies.hpp"
#include "sph/cloud/cloud.hpp"
#include "sph/motion/ambient.hpp"
#include "sph/motion/pressure_system.hpp"
#include "sph/motion/time_step.hpp"
#include "sph/operators/boundary_fits.hpp"
#include "sph/operators/stencils.hpp"
#include "tree/base/phase.hpp"

namespace vortree::sph {

/// What a step is told besides the particles.
///
/// step             from t to `later`
/// far_field        gives the velocity of outer nodes; null: they have that of the stream
/// bodies           whose walls the nodes are; null without any
/// wall_vorticity   at t, of those nodes by their number; empty before the first step
/// tolerance        of the pressure
struct MomentumInput {
  TimeStep step;
  double later = 0;
  const Ambient& ambient;
  const BiotSavart* far_field = nullptr;
  const StandingBodies* bodies = nullptr;
  const std::vector<double>& wall_vorticity;
  double tolerance = 1e-5;
};

/// Of all particles at one time. What a node at the edge has at the end of a step must not meet
/// what fluid beside it has at its beginning: their difference over a spacing would be as large as
/// the change in time.
struct StepVelocities {
  std::vector<double> u, v;
  [[nodiscard]] Vec2 at(std::size_t i) const { return {u[i], v[i]}; }
};

/// How the two systems were solved.
struct Iterations {
  int pressure = 0, viscosity = 0;
};

/// The velocity and pressure of a step of incompressible flow, for particles that have come to
/// their places, h = b1 u^n - b2 u^{n-1}:
///
///   lap p = div h/dt,             wall    dp/dn = -nu d(omega)/ds - n.a_wall
///                                 outer   dp/dn = -n.(du/dt + u.grad u)
///                                 outlet  dp/d tau = -tau.(du_b/dt + u.grad u)
///   (b0 - nu dt lap) u = h - dt grad p,   wall u = u_wall, outer by far field, outlet nu = 0
///
/// In h the wall carries b0 u_wall. The outlet's pressure balances the momentum along it, tau; u_b
/// is what all vorticity and the stream make there. Bernoulli's law instead lets a wake's own
/// velocity feed the pressure that drives it. Convection at the box is that of t.
///
/// error    second order in dt and, with degree 2, in s
/// source   Karniadakis, Israeli & Orszag, J. Comput. Phys. 97 (1991), for the slope at walls
class Momentum {
 public:
  /// throws  std::runtime_error if a system is not solved
  Iterations solve(Cloud& cloud, const Stencils& stencils, const OperatorOptions& options,
                   const MomentumInput& input, const tree::Phase& phase);

  /// What the vorticity makes along the outlet, node by node, in the mean over the time that fluid
  /// takes to pass a spacing: to be saved.
  std::vector<double> along_outlet;

 private:
  void set_boundary(Cloud& cloud, const MomentumInput& input);
  void set_outlet(const Cloud& cloud, const StepVelocities& before, const Stencils& stencils,
                  const MomentumInput& input);
  void set_slopes(const Cloud& cloud, const StepVelocities& before, const Stencils& stencils,
                  const MomentumInput& input);
  int diffuse(Cloud& cloud, const MomentumInput& input);

  BoundaryFits fits_;
  PressureSystem pressure_;
  std::vector<std::uint32_t> outlet_;        // its nodes, one after another
  std::vector<double> outlet_u_, outlet_v_;  // of the far field there
  std::vector<double> hu_, hv_, source_, given_, px_, py_;
  std::vector<double> viscous_value_, viscous_factor_;
};

/// nu-free part of the slope at walls, d(omega)/ds to fourth order at each of n nodes around.
[[nodiscard]] double slope_along_wall(std::span<const double> omega, std::int32_t node,
                                      double spacing);

}  // namespace vortree::sph
