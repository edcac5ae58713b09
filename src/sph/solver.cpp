#include "sph/solver.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "base/rounded.hpp"
#include "flow/near_wake.hpp"
#include "sph/adapt/population.hpp"
#include "sph/adapt/refine.hpp"
#include "sph/adapt/wishes.hpp"
#include "sph/boundary/open_boundary.hpp"
#include "sph/boundary/tuning.hpp"
#include "sph/motion/edge_filter.hpp"
#include "sph/motion/initial_vortices.hpp"
#include "sph/motion/periodic_flow.hpp"
#include "sph/motion/potential_flow.hpp"
#include "sph/motion/shift.hpp"
#include "sph/motion/tuning.hpp"
#include "sph/operators/interpolate.hpp"

namespace vortree::sph {
namespace {

const std::string settings_to_blame =
    "sph.shift, time.dt, sph.spacing, sph.levels and sph.box are what such flows hang on";

}  // namespace

SphSolver::SphSolver(SphSetup setup)
    : setup_(std::move(setup)),
      far_field_(setup_.box, edge_share * std::min(setup_.box.size().x, setup_.box.size().y),
                 setup_.ambient.spin.circulation(setup_.area),
                 faintest_vortex * setup_.scales.speed * setup_.scales.length) {
  start();
}

void SphSolver::start() {
  cloud_ = starting_cloud(setup_);
  for (const std::uint32_t i : in_order(cloud_, ParticleKind::wall)) wall_.push_back(cloud_.at(i));
  stencils_.renew(cloud_, setup_.operators);
  setup_.periodic ? start_periodic_flow() : start_past_body();
  look();
  force_ = {
      .t = 0, .impulse = impulse(), .frame = setup_.area * setup_.ambient.plunge.acceleration(0)};
  measure();
}

void SphSolver::start_past_body() {
  // By Kelvin's theorem: no vorticity comes from nowhere.
  const double vortices =
      setup_.initial ? add_initial_vortices(cloud_, *setup_.initial, setup_.centre) : 0;
  start_potential_flow(cloud_, stencils_, setup_.operators, setup_.ambient, setup_.far_field,
                       -vortices);
}

/// As fine as its vorticity asks for, which is known where particles are.
void SphSolver::start_periodic_flow() {
  begin(cloud_, *setup_.periodic);
  const auto& by_vorticity = setup_.by_vorticity;
  const double finer = by_vorticity ? setup_.wanted.coarsest() / by_vorticity->finest : 1;
  for (double level = 1; level < finer; level *= 2) {
    find_slopes(cloud_, stencils_, slopes_);
    renew_particles();
    settle(cloud_, setup_.operators);
    stencils_.renew(cloud_, setup_.operators);
    begin(cloud_, *setup_.periodic);
  }
}

/// What follows from particles that are where they are and carry what they carry.
void SphSolver::look() {
  find_slopes(cloud_, stencils_, slopes_);
  if (setup_.shape) look_at_wall();
}

void SphSolver::look_at_wall() {
  far_field_.renew(cloud_, slopes_, setup_.ambient.steady);
  wall_vorticity_.resize(wall_.size()), wall_pressure_.resize(wall_.size());
  for (std::size_t i = 0; i < cloud_.size(); ++i)
    if (cloud_.kind[i] == ParticleKind::wall) {
      wall_vorticity_[cloud_.place[i]] = vorticity(slopes_[i]);
      wall_pressure_[cloud_.place[i]] = cloud_.p[i];
    }
  if (substeps_ > 0) return;
  // The wall still slips: its vorticity is a sheet.
  far_field_.add_sheet(cloud_, setup_.ambient.spin.rate);
  wall_vorticity_.clear();
}

void SphSolver::step(const tree::Phase& phase) {
  const double end = static_cast<double>(steps_ + 1) * setup_.dt;
  const double begin = time_;
  const Checkpoint before_step = checkpoint();
  Vec2 given{};
  Traction before = traction();
  try {
    while (end - time_ > 1e-9 * setup_.dt) {
      const double dt = next_dt(end - time_);
      substep(dt, phase);
      const Traction now = traction();
      given += dt / 2 * (before.pressure + now.pressure);
      before = now;
    }
  } catch (const std::bad_alloc&) {
    go_back(before_step);
    throw;
  } catch (const std::exception& failed) {
    go_back(before_step);
    throw flow::Diverged(failed.what());
  }
  time_ = end;
  ++steps_;
  phase("output");
  force_ = {.t = end,
            .impulse = impulse(),
            .pressure = 1 / (end - begin) * given,
            .friction = before.friction,
            .frame = setup_.area * setup_.ambient.plunge.acceleration(end)};
  measure();
}

SphSolver::Checkpoint SphSolver::checkpoint() const {
  return {cloud_, far_field_, momentum_.along_outlet, time_, last_dt_, substeps_, iterations_};
}

void SphSolver::go_back(const Checkpoint& to) {
  cloud_ = to.cloud, far_field_ = to.far_field, momentum_.along_outlet = to.along_outlet;
  time_ = to.time, last_dt_ = to.last_dt, substeps_ = to.substeps, iterations_ = to.iterations;
  cloud_.was.assign(cloud_.size(), -1);
  stencils_.renew(cloud_, setup_.operators);
  look();
}

/// As long as the Courant number and the step before allow, and a whole part of what is left.
/// throws  std::runtime_error if that is too short to go on
double SphSolver::next_dt(double left) const {
  double most = setup_.dt;
  for (std::size_t i = 0; i < cloud_.size(); ++i) {
    const double u = std::sqrt(dot(cloud_.velocity(i), cloud_.velocity(i)));
    if (u > most_speed * setup_.scales.speed)
      throw std::runtime_error("a particle moves " + rounded(u / setup_.scales.speed, 3) +
                               " times as fast as the stream; " + settings_to_blame);
    if (u * most > largest_courant * setup_.courant * cloud_.spacing[i])
      most = largest_courant * setup_.courant * cloud_.spacing[i] / u;
  }
  if (most < shortest_step * setup_.dt)
    throw std::runtime_error("particles are so fast that a step of " + rounded(setup_.dt, 3) +
                             " would have to be shorter than " + rounded(most, 3) + "; " +
                             settings_to_blame);
  const auto parts = [&](double longest) {
    return std::ceil(left / std::min(most, longest) - 1e-9);
  };
  if (last_dt_ == 0) return left / parts((setup_.periodic ? 1 : first_step) * setup_.dt);
  const double few = parts(step_growth * last_dt_);
  // From five parts of a step to four, and down to one, steps grow by more.
  return left / (few > 5 ? few : parts(2 * last_dt_));
}

void SphSolver::substep(double dt, const tree::Phase& phase) {
  const TimeStep step{dt, last_dt_ > 0 ? dt / last_dt_ : 0};
  phase("move");
  filter_edges(cloud_, stencils_, slopes_, setup_.operators, edge_filter);
  shift_and_move(cloud_, stencils_, slopes_, step, setup_.shift);
  phase("adapt");
  const Ambient& ambient = setup_.ambient;
  far_field_.carry_out(cloud_, slopes_, ambient.steady, dt * ambient.stream(time_ + dt / 2), dt);
  renew_particles();
  if (substeps_ % sort_every == 0) sort(cloud_);
  phase("neighbors");
  stencils_.find_neighbors(cloud_, setup_.operators);
  number(cloud_);
  phase("operators");
  stencils_.fit(cloud_, setup_.operators);
  iterations_ = momentum_.solve(cloud_, stencils_, setup_.operators,
                                {.step = step,
                                 .later = time_ + dt,
                                 .ambient = setup_.ambient,
                                 .far_field = setup_.far_field ? &far_field_ : nullptr,
                                 .wall_vorticity = wall_vorticity_,
                                 .wall_spacing = setup_.wall_spacing,
                                 .tolerance = setup_.tolerance},
                                phase);
  phase("slopes");
  time_ += dt, last_dt_ = dt, ++substeps_;
  look();
}

void SphSolver::renew_particles() {
  const double period = setup_.operators.period;
  Population population(cloud_, stencils_, slopes_, period);
  const std::vector<double> wanted = wishes(population, setup_.wanted, setup_.by_vorticity);
  correct_volumes(population, wanted);
  take_away(population, setup_.confines);
  fill_gaps(population, setup_.confines);
  refine(population, wanted);
  population.finish();
  wrap(cloud_, period);
}

/// Force per unit density that the fluid puts on the body: int -p n + nu (grad u + grad u^T) n ds.
SphSolver::Traction SphSolver::traction() const {
  Traction sum{};
  for (std::size_t i = 0; i < cloud_.size(); ++i) {
    if (cloud_.kind[i] != ParticleKind::wall) continue;
    const Vec2 n = cloud_.normal(i);
    const auto& [u, v, u_before, v_before, p] = slopes_[i];
    const double ds = setup_.wall_spacing, shear = u.y + v.x;
    sum.pressure += (-ds * cloud_.p[i]) * n;
    sum.friction +=
        ds * setup_.ambient.nu * Vec2{2 * u.x * n.x + shear * n.y, shear * n.x + 2 * v.y * n.y};
  }
  return sum;
}

/// Length of the closed wake; by the particles near its line only.
double SphSolver::bubble_length() const {
  const flow::WakeLine line = flow::wake_line(wall_, *setup_.shape, setup_.ambient.steady);
  const Vec2 along = line.direction, across{-along.y, along.x};
  std::vector<std::uint32_t> near;
  for (std::size_t i = 0; i < cloud_.size(); ++i)
    if (dot(cloud_.at(i), along) > 0 && std::abs(dot(cloud_.at(i), across)) < 2 * cloud_.spacing[i])
      near.push_back(static_cast<std::uint32_t>(i));
  const Interpolated at = interpolate(cloud_, slopes_, near, line.points());
  return flow::bubble_length(line, at.u, at.v);
}

Vec2 SphSolver::impulse() const {
  return far_field_.impulse();
}

void SphSolver::measure() {
  setup_.shape ? measure_past_body() : measure_periodic();
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
  double volume = -setup_.area;
  const Vec2 box = setup_.box.size();
  double filled = 0;
  std::size_t least = cloud_.size();
  for (std::size_t i = 0; i < cloud_.size(); ++i) {
    filled += cloud_.inside(i) ? cloud_.volume(i) : cloud_.volume(i) / 2;
    if (cloud_.inside(i)) least = std::min(least, stencils_.length(i));
  }
  volume += box.x * box.y;
  const Vec2 moment = force_.impulse;
  const Ambient& ambient = setup_.ambient;
  const bool wake = dot(ambient.steady, ambient.steady) > 0 && ambient.plunge.frequency == 0 &&
                    ambient.spin.rate == 0 && steps_ > 0;
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

/// By the particles, or the far field where there are none.
flow::Samples SphSolver::sample(tree::Points at) const {
  const std::size_t m = at.size();
  std::vector<double> x(m), y(m);
  for (std::size_t k = 0; k < m; ++k)
    x[k] = at.x[k] - setup_.centre.x, y[k] = at.y[k] - setup_.centre.y;
  std::vector<std::uint32_t> all(cloud_.size());
  std::iota(all.begin(), all.end(), 0u);
  const double period = setup_.operators.period;
  for (std::vector<double>* places : {&x, &y})
    for (double& one : *places) one = wrapped(one, period);
  auto [u, v, omega, covered] = interpolate(cloud_, slopes_, all, {x, y}, period);
  if (!setup_.shape) return {std::move(u), std::move(v), std::move(omega)};
  std::vector<double> far_x, far_y;
  std::vector<std::size_t> far;
  for (std::size_t k = 0; k < m; ++k) {
    const bool body = setup_.shape->distance({x[k], y[k]}) < 0;
    if (body) u[k] = v[k] = omega[k] = 0;
    if (!body && !covered[k]) far.push_back(k), far_x.push_back(x[k]), far_y.push_back(y[k]);
  }
  std::vector<double> far_u(far.size()), far_v(far.size());
  far_field_.velocity(far_x, far_y, setup_.ambient.stream(time_), far_u, far_v);
  for (std::size_t k = 0; k < far.size(); ++k) u[far[k]] = far_u[k], v[far[k]] = far_v[k];
  return {std::move(u), std::move(v), std::move(omega)};
}

flow::FrameTable SphSolver::frame_table() const {
  if (!setup_.shape) return {"energy.csv", {"t", "energy", "enstrophy"}};
  return {"wall.csv", {"t", "T", "angle_deg", "vorticity", "pressure"}};
}

std::vector<double> SphSolver::frame_rows() const {
  if (!setup_.shape)
    return {time(), flow::measured(measures_, "energy"), flow::measured(measures_, "enstrophy")};
  std::vector<double> rows;
  if (steps_ == 0) return rows;  // the wall vorticity of an impulsive start is infinite
  const Vec2 s = setup_.scales.along;
  for (std::size_t k = 0; k < wall_.size(); ++k) {
    const Vec2 d = wall_[k];
    const double angle = std::atan2(s.x * d.y - s.y * d.x, dot(s, d)) * 180 / std::numbers::pi;
    rows.insert(rows.end(),
                {time(), setup_.scales.T(time()), angle, wall_vorticity_[k], wall_pressure_[k]});
  }
  return rows;
}

namespace {

/// Columns of the particles that a frame does not show.
constexpr std::pair<const char*, std::vector<double> Cloud::*> hidden[] = {
    {"x_in_flow", &Cloud::x},       {"y_in_flow", &Cloud::y}, {"u_before", &Cloud::u_before},
    {"v_before", &Cloud::v_before}, {"normal_x", &Cloud::nx}, {"normal_y", &Cloud::ny}};

}  // namespace

void SphSolver::save(flow::State& state) const {
  for (const auto& [name, column] : hidden) state[name] = cloud_.*column;
  state["place"].assign(cloud_.place.begin(), cloud_.place.end());
  state["left_x"] = far_field_.left_x;
  state["left_y"] = far_field_.left_y;
  state["left_gamma"] = far_field_.left_gamma;
  state["leaving"] = far_field_.leaving;
  state["travelled"] = {far_field_.travelled.x, far_field_.travelled.y};
  state["along_outlet"] = momentum_.along_outlet;
  state["last_dt"] = {last_dt_};
  state["substeps"] = {static_cast<double>(substeps_)};
  state["largest_drift"] = {drift_};
  state["pressure_iterations"] = {static_cast<double>(iterations_.pressure)};
  state["mean_pressure_force"] = {force_.pressure.x, force_.pressure.y};
  state["friction"] = {force_.friction.x, force_.friction.y};
}

void SphSolver::restore(long steps, const flow::Columns& columns, const flow::State& state) {
  steps_ = steps;
  time_ = time();
  cloud_ = {};
  for (const auto& [name, column] : hidden) cloud_.*column = flow::saved(state, name);
  cloud_.u = flow::column(columns, "u"), cloud_.v = flow::column(columns, "v");
  cloud_.p = flow::column(columns, "pressure");
  cloud_.spacing = flow::column(columns, "spacing");
  for (const double kind : flow::column(columns, "kind"))
    cloud_.kind.push_back(static_cast<ParticleKind>(kind));
  for (const double place : flow::saved(state, "place"))
    cloud_.place.push_back(static_cast<std::int32_t>(place));
  cloud_.was.assign(cloud_.place.size(), -1);
  far_field_.left_x = flow::saved(state, "left_x");
  far_field_.left_y = flow::saved(state, "left_y");
  far_field_.left_gamma = flow::saved(state, "left_gamma");
  momentum_.along_outlet = flow::saved(state, "along_outlet");
  far_field_.leaving = flow::saved(state, "leaving");
  const auto saved_pair = [&](const char* name) {
    const std::vector<double>& of = flow::saved(state, name);
    return Vec2{of.at(0), of.at(1)};
  };
  far_field_.travelled = saved_pair("travelled");
  last_dt_ = flow::saved_number(state, "last_dt");
  substeps_ = static_cast<long>(flow::saved_number(state, "substeps"));
  drift_ = flow::saved_number(state, "largest_drift");
  iterations_.pressure = static_cast<int>(flow::saved_number(state, "pressure_iterations"));
  stencils_.renew(cloud_, setup_.operators);
  look();
  force_ = {.t = time(),
            .impulse = impulse(),
            .pressure = saved_pair("mean_pressure_force"),
            .friction = saved_pair("friction"),
            .frame = setup_.area * setup_.ambient.plunge.acceleration(time())};
  measure();
}

}  // namespace vortree::sph
