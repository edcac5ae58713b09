#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "flow/near_wake.hpp"
#include "sph/motion/periodic_flow.hpp"
#include "sph/operators/interpolate.hpp"
#include "sph/solver.hpp"

// What is told of a flow: measures after each step, columns and tables of frames, samples anywhere.
namespace vortree::sph {

/// Length of the closed wake; by the particles near its line only.
double SphSolver::bubble_length() const {
  const flow::WakeLine line =
      flow::wake_line(wall_, *setup_.bodies().shape(), setup_.ambient.steady);
  const Vec2 along = line.direction, across{-along.y, along.x};
  std::vector<std::uint32_t> near;
  for (std::size_t i = 0; i < cloud_.size(); ++i)
    if (dot(cloud_.at(i), along) > 0 && std::abs(dot(cloud_.at(i), across)) < 2 * cloud_.spacing[i])
      near.push_back(static_cast<std::uint32_t>(i));
  const Interpolated at = interpolate(cloud_, slopes_, near, line.points());
  return flow::bubble_length(line, at.u, at.v);
}

void SphSolver::measure() {
  past_bodies() ? measure_past_body() : measure_periodic();
}

void SphSolver::measure_periodic() {
  const PeriodicBudget now = budget(cloud_, slopes_, *setup_.periodic, time());
  const Vec2 box = setup_.box.size();
  const double size = setup_.scales.speed * box.x * box.y;
  measures_ = {{"particles", "", static_cast<double>(cloud_.size())},
               {"volume", "", now.volume / (box.x * box.y)},
               {"momentum_x", "", now.momentum.x / size},
               {"momentum_y", "", now.momentum.y / size},
               {"energy", "L^4/T^2", now.energy},
               {"enstrophy", "L^2/T^2", now.enstrophy},
               {"velocity_error", "", now.velocity_error},
               {"pressure_error", "", now.pressure_error},
               {"pressure_iterations", "", static_cast<double>(iterations_.pressure)},
               {"least_neighbors", "", static_cast<double>(stencils_.least_length())}};
  drift_ = std::max(drift_, std::sqrt(dot(now.momentum, now.momentum)) / size);
}

void SphSolver::measure_past_body() {
  const flow::Scales& scales = setup_.scales;
  const double circulation = far_field_.circulation();
  double volume = -setup_.bodies().area();
  const Vec2 box = setup_.box.size();
  double filled = 0;
  std::size_t least = cloud_.size();
  for (std::size_t i = 0; i < cloud_.size(); ++i) {
    filled += cloud_.inside(i) ? cloud_.volume(i) : cloud_.volume(i) / 2;
    if (cloud_.inside(i)) least = std::min(least, stencils_.length(i));
  }
  volume += box.x * box.y;
  const Vec2 moment = far_field_.impulse();
  const Ambient& ambient = setup_.ambient;
  const bool wake = setup_.bodies().size() == 1 && dot(ambient.steady, ambient.steady) > 0 &&
                    !ambient.motion.moves() && steps_ > 0;
  measures_ = {{"particles", "", static_cast<double>(cloud_.size())},
               {"circulation", "L^2/T", circulation},
               {"impulse_x", "L^3/T", moment.x},
               {"impulse_y", "L^3/T", moment.y},
               {"second_moment", "L^4/T", far_field_.second_moment()},
               {"bubble_length", "", wake ? bubble_length() / scales.length : 0},
               {"separation_deg", "deg",
                wake ? flow::separation_angle(wall_vorticity_, wall_, ambient.steady) : 0},
               {"volume", "", filled / volume},
               {"pressure_iterations", "", static_cast<double>(iterations_.pressure)},
               {"least_neighbors", "", static_cast<double>(least)}};
  flow::add_place(measures_, ambient.motion, time_);
  drift_ = std::max(drift_, std::abs(circulation) / (scales.speed * scales.length));
}

flow::Columns SphSolver::columns() const {
  std::vector<double> x = cloud_.x, y = cloud_.y, omega(cloud_.size()), kind(cloud_.size());
  for (std::size_t i = 0; i < cloud_.size(); ++i) {
    x[i] += setup_.centre.x, y[i] += setup_.centre.y;
    omega[i] = vorticity(slopes_[i]);
    kind[i] = static_cast<double>(cloud_.kind[i]);
  }
  return {{"x", "L", std::move(x)},
          {"y", "L", std::move(y)},
          {"u", "L/T", cloud_.u},
          {"v", "L/T", cloud_.v},
          {"pressure", "L^2/T^2", cloud_.p},
          {"vorticity", "1/T", std::move(omega)},
          {"spacing", "L", cloud_.spacing},
          {"kind", "", std::move(kind)}};
}

/// Places as the particles see them, and what is interpolated there.
struct SphSolver::AmongParticles {
  std::vector<double> x, y;
  Interpolated found;
};

SphSolver::AmongParticles SphSolver::among_particles(tree::Points at) const {
  const std::size_t m = at.size();
  std::vector<double> x(m), y(m);
  for (std::size_t k = 0; k < m; ++k)
    x[k] = at.x[k] - setup_.centre.x, y[k] = at.y[k] - setup_.centre.y;
  std::vector<std::uint32_t> all(cloud_.size());
  std::iota(all.begin(), all.end(), 0u);
  const double period = setup_.operators.period;
  for (std::vector<double>* places : {&x, &y})
    for (double& one : *places) one = wrapped(one, period);
  Interpolated found = interpolate(cloud_, slopes_, all, {x, y}, period);
  return {std::move(x), std::move(y), std::move(found)};
}

/// By the particles, or the far field where there are none.
flow::Samples SphSolver::sample(tree::Points at) const {
  auto [x, y, found] = among_particles(at);
  auto& [u, v, omega, p, covered] = found;
  if (!past_bodies()) return {std::move(u), std::move(v), std::move(omega)};
  std::vector<double> far_x, far_y;
  std::vector<std::size_t> far;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const bool body = setup_.bodies().shape()->distance({x[k], y[k]}) < 0;
    if (body) u[k] = v[k] = omega[k] = 0;
    if (!body && !covered[k]) far.push_back(k), far_x.push_back(x[k]), far_y.push_back(y[k]);
  }
  std::vector<double> far_u(far.size()), far_v(far.size());
  far_field_.velocity(far_x, far_y, setup_.ambient.stream(time_), far_u, far_v);
  for (std::size_t k = 0; k < far.size(); ++k) u[far[k]] = far_u[k], v[far[k]] = far_v[k];
  return {std::move(u), std::move(v), std::move(omega)};
}

/// p + |u|^2/2 - |U|^2/2 in a frame at rest, far from all vorticity, by all of it and by the wall
/// (vortex/pressure.hpp).
double SphSolver::head_beyond_vorticity(Vec2 at) const {
  const BiotSavart::Vortices& all = far_field_.vortices();
  const auto dipole = [](Vec2 strength, Vec2 from) {
    return dot(strength, from) / (2 * std::numbers::pi * dot(from, from));
  };
  double sum = 0;
  for (std::size_t j = 0; j < all.x.size(); ++j)
    sum += all.gamma[j] * dipole({all.v[j], -all.u[j]}, at - Vec2{all.x[j], all.y[j]});
  for (std::size_t i = 0; i < cloud_.size(); ++i) {
    if (cloud_.kind[i] != ParticleKind::wall) continue;
    const StandingBody& body = setup_.bodies()[setup_.bodies().of_node(cloud_.place[i])];
    const Vec2 x = cloud_.at(i), n = cloud_.normal(i), lever = x - body.centre;
    const double mu = cloud_.p[i] + body.spin * body.spin / 2 * dot(lever, lever),
                 lambda = setup_.ambient.nu * wall_vorticity_[cloud_.place[i]];
    sum += body.spacing * dipole(mu * n - lambda * left_of(n), at - x);
  }
  return sum;
}

/// What the particles' own pressure, that of the body's frame but for X'' x, has far away: as it
/// goes on from where fluid comes into the box.
double SphSolver::far_pressure() const {
  const Vec2 stream = setup_.ambient.stream(time()),
             faster = setup_.ambient.motion.at(time()).acceleration;
  const bool still = dot(stream, stream) == 0;
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < cloud_.size(); ++i) {
    const bool comes_in = still || dot(cloud_.normal(i), stream) > 0;
    if (cloud_.kind[i] != ParticleKind::outer || !comes_in) continue;
    const Vec2 x = cloud_.at(i), u = cloud_.velocity(i);
    sum += cloud_.p[i] - dot(faster, x) + (dot(u, u) - dot(stream, stream)) / 2 -
           head_beyond_vorticity(x);
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

/// None of an impulsive start, nor where the places reach beyond the particles. In a periodic box
/// its mean is 0.
std::vector<double> SphSolver::pressure(tree::Points at) const {
  if (past_bodies() && steps_ == 0) return {};
  auto [x, y, found] = among_particles(at);
  std::vector<double>& p = found.p;
  if (!past_bodies()) return std::move(p);
  const double far = far_pressure();
  const Vec2 faster = setup_.ambient.motion.at(time()).acceleration;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const bool body = setup_.bodies().shape()->distance({x[k], y[k]}) < 0;
    if (!body && !found.covered[k]) return {};
    p[k] = body ? 0 : p[k] - dot(faster, {x[k], y[k]}) - far;
  }
  return std::move(p);
}

flow::FrameTable SphSolver::frame_table() const {
  if (!past_bodies()) return {"energy.csv", {"t", "energy", "enstrophy"}};
  if (setup_.bodies().size() == 1)
    return {"wall.csv", {"t", "T", "angle_deg", "vorticity", "pressure"}};
  return {"wall.csv", {"t", "T", "body", "angle_deg", "vorticity", "pressure"}};
}

std::vector<double> SphSolver::frame_rows() const {
  if (!past_bodies())
    return {time(), flow::measured(measures_, "energy"), flow::measured(measures_, "enstrophy")};
  std::vector<double> rows;
  if (steps_ == 0) return rows;  // the wall vorticity of an impulsive start is infinite
  const StandingBodies& bodies = setup_.bodies();
  const Vec2 s = setup_.scales.along;
  for (std::size_t k = 0; k < wall_.size(); ++k) {
    const std::size_t body = bodies.of_node(static_cast<std::int32_t>(k));
    const Vec2 d = wall_[k] - bodies[body].centre;
    const double angle = std::atan2(s.x * d.y - s.y * d.x, dot(s, d)) * 180 / std::numbers::pi;
    rows.insert(rows.end(), {time(), setup_.scales.T(time())});
    if (bodies.size() > 1) rows.push_back(static_cast<double>(body + 1));
    rows.insert(rows.end(), {angle, wall_vorticity_[k], wall_pressure_[k]});
  }
  return rows;
}

}  // namespace vortree::sph
