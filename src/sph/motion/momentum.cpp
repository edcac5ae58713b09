#include "sph/motion/momentum.hpp"

#include <stdexcept>
#include <string>

#include "base/rounded.hpp"
#include "sph/motion/tuning.hpp"
#include "sph/operators/derivatives.hpp"
#include "sph/pressure/diagonal_dominant.hpp"

namespace vortree::sph {
namespace {

/// u.grad u at a particle.
Vec2 convection(const StepVelocities& of, const Stencils& stencils, std::size_t i) {
  Vec2 sum{};
  const Vec2 u = of.at(i);
  stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
    const double along = u.x * stencils.weight(0, slot) + u.y * stencils.weight(1, slot);
    sum += along * (of.at(j) - u);
  });
  return sum;
}

/// Of the stream that a body meets which plunges: differences as those of the fluid.
Vec2 rate_of_stream(const MomentumInput& input) {
  const TimeStep& step = input.step;
  const auto stream = [&](double ago) { return input.ambient.stream(input.later - ago); };
  const Vec2 then = stream(0), now = stream(step.dt);
  if (step.ratio == 0) return 1 / step.dt * (then - now);
  const Vec2 before = stream(step.dt + step.dt / step.ratio);
  return 1 / step.dt * (step.b0() * then - step.b1() * now + step.b2() * before);
}

Vec2 wall_velocity(const Cloud& cloud, std::size_t i, const MomentumInput& input) {
  return input.bodies->wall_velocity(cloud.place[i], cloud.at(i));
}

/// Of the pressure at a node of a wall.
double slope_at_wall(const Cloud& cloud, std::size_t i, const MomentumInput& input) {
  const std::int32_t node = cloud.place[i];
  const StandingBody& body = (*input.bodies)[input.bodies->of_node(node)];
  const double along = slope_along_wall(body.of(input.wall_vorticity),
                                        node - static_cast<std::int32_t>(body.first), body.spacing);
  return -input.ambient.nu * along - dot(cloud.normal(i), body.wall_acceleration(cloud.at(i)));
}

}  // namespace

double slope_along_wall(std::span<const double> omega, std::int32_t node, double spacing) {
  const auto n = static_cast<std::int32_t>(omega.size());
  if (n < 5) return 0;
  const auto at = [&](std::int32_t k) { return omega[(node + k + n) % n]; };
  return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * spacing);
}

Iterations Momentum::solve(Cloud& cloud, const Stencils& stencils, const OperatorOptions& options,
                           const MomentumInput& input, const tree::Phase& phase) {
  const std::size_t n = cloud.size();
  const TimeStep& step = input.step;
  phase("boundary");
  hu_.resize(n), hv_.resize(n), source_.resize(n), given_.assign(n, 0);
  px_.resize(n), py_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool wall = cloud.kind[i] == ParticleKind::wall;
    const Vec2 at_wall = wall ? step.b0() * wall_velocity(cloud, i, input) : Vec2{};
    hu_[i] = wall ? at_wall.x : step.b1() * cloud.u[i] - step.b2() * cloud.u_before[i];
    hv_[i] = wall ? at_wall.y : step.b1() * cloud.v[i] - step.b2() * cloud.v_before[i];
  }
  const StepVelocities now{cloud.u, cloud.v};
  set_boundary(cloud, input);
  fits_.renew(cloud, stencils, options);
  set_slopes(cloud, now, stencils, input);
  set_outlet(cloud, now, stencils, input);
  phase("pressure");
  find_divergence(hu_, hv_, stencils, source_);
  for (double& value : source_) value /= step.dt;
  pressure_.renew(cloud, stencils, fits_, true);
  Iterations iterations;
  iterations.pressure = pressure_.solve(source_, given_, cloud.p, input.tolerance).iterations;
  phase("viscosity");
  find_gradient(cloud.p, stencils, px_, py_);
  for (std::size_t i = 0; i < n; ++i) {
    if (!cloud.free(i) && !cloud.passed(i)) continue;
    hu_[i] -= step.dt * px_[i], hv_[i] -= step.dt * py_[i];
    cloud.u[i] += step.ratio * (now.u[i] - cloud.u_before[i]);
    cloud.v[i] += step.ratio * (now.v[i] - cloud.v_before[i]);
  }
  iterations.viscosity = diffuse(cloud, input);
  cloud.u_before = now.u, cloud.v_before = now.v;
  return iterations;
}

/// Velocities of wall and outer nodes at the end of the step, and of the far field at the outlet.
void Momentum::set_boundary(Cloud& cloud, const MomentumInput& input) {
  const Vec2 stream = input.ambient.stream(input.later);
  std::vector<std::uint32_t> outer;
  outlet_ = in_order(cloud, ParticleKind::outlet);
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    if (cloud.kind[i] == ParticleKind::wall) {
      const Vec2 u = wall_velocity(cloud, i, input);
      cloud.u[i] = u.x, cloud.v[i] = u.y;
    }
    if (cloud.kind[i] == ParticleKind::outer) outer.push_back(i);
  }
  const auto gather = [](const std::vector<double>& of, const std::vector<std::uint32_t>& nodes) {
    std::vector<double> values;
    for (const std::uint32_t i : nodes) values.push_back(of[i]);
    return values;
  };
  std::vector<double> u(outer.size(), stream.x), v(outer.size(), stream.y);
  outlet_u_.assign(outlet_.size(), 0), outlet_v_.assign(outlet_.size(), 0);
  if (input.far_field) {
    input.far_field->velocity(gather(cloud.x, outer), gather(cloud.y, outer), stream, u, v);
    input.far_field->velocity_among(gather(cloud.x, outlet_), gather(cloud.y, outlet_), outlet_u_,
                                    outlet_v_);
  }
  for (std::size_t k = 0; k < outer.size(); ++k) cloud.u[outer[k]] = u[k], cloud.v[outer[k]] = v[k];
}

void Momentum::set_outlet(const Cloud& cloud, const StepVelocities& before,
                          const Stencils& stencils, const MomentumInput& input) {
  const bool known = along_outlet.size() == outlet_.size();
  along_outlet.resize(outlet_.size());
  double sum = 0, rate_before = 0;
  const Vec2 streaming = rate_of_stream(input);
  for (std::size_t k = 0; k < outlet_.size(); ++k) {
    const std::uint32_t i = outlet_[k];
    const Vec2 out = -1 * cloud.normal(i), tau{-out.y, out.x};
    const double now = dot({outlet_u_[k], outlet_v_[k]}, tau);
    const double memory = cloud.spacing[i] / dot(input.ambient.steady, out) + input.step.dt;
    const double speeding = known ? (now - along_outlet[k]) / memory : 0;
    along_outlet[k] = known ? along_outlet[k] + input.step.dt * speeding : now;
    const double rate = speeding + dot(streaming + convection(before, stencils, i), tau);
    if (k > 0) {
      const Vec2 step = cloud.at(i) - cloud.at(outlet_[k - 1]);
      sum += 0.5 * (rate + rate_before) * dot(step, tau);
    }
    rate_before = rate;
    given_[i] = -sum;
  }
}

void Momentum::set_slopes(const Cloud& cloud, const StepVelocities& before,
                          const Stencils& stencils, const MomentumInput& input) {
  const TimeStep& step = input.step;
  for (const BoundaryFits::Node& node : fits_.nodes()) {
    const auto i = static_cast<std::size_t>(node.particle);
    const Vec2 u = cloud.velocity(i), normal = cloud.normal(i);
    if (cloud.kind[i] == ParticleKind::wall) {
      given_[i] = slope_at_wall(cloud, i, input);
    } else if (cloud.kind[i] == ParticleKind::outer) {
      const Vec2 rate = 1 / step.dt * (step.b0() * u - Vec2{hu_[i], hv_[i]});
      given_[i] = -dot(normal, rate + convection(before, stencils, i));
    }
  }
}

/// By the rows of the pressure, which are V lap inside.
int Momentum::diffuse(Cloud& cloud, const MomentumInput& input) {
  const std::size_t n = cloud.size();
  const double by = input.ambient.nu * input.step.dt;
  viscous_value_.assign(n, input.step.b0()), viscous_factor_.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    if (cloud.inside(i)) {
      viscous_factor_[i] = by / cloud.volume(i);
    } else if (cloud.kind[i] != ParticleKind::outlet) {
      viscous_value_[i] = 1;
      hu_[i] = cloud.u[i], hv_[i] = cloud.v[i];
    }
  }
  const auto solved =
      sph::solve({pressure_.rows(), pressure_.singles(), viscous_value_, viscous_factor_},
                 {hu_, hv_}, {cloud.u, cloud.v}, viscous_tolerance, most_iterations);
  for (const Solved& one : solved)
    if (!(one.residual < 100 * viscous_tolerance))
      throw std::runtime_error("the viscous step is not solved: a residual of " +
                               rounded(one.residual, 3) + " is left");
  return solved[0].iterations;
}

}  // namespace vortree::sph
