#include "sph/solver.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>
#include <utility>

#include "base/rounded.hpp"
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

namespace vortree::sph {
namespace {

const std::string settings_to_blame =
    "sph.shift, time.dt, sph.spacing, sph.levels and sph.box are what such flows hang on";

}  // namespace

SphSolver::SphSolver(SphSetup setup)
    : setup_(std::move(setup)),
      far_field_(setup_.box, edge_share * std::min(setup_.box.size().x, setup_.box.size().y),
                 setup_.bodies(), faintest_vortex * setup_.scales.speed * setup_.scales.length),
      smooth_pressure_(setup_.bodies().size()),
      traction_(setup_.bodies().size()) {
  start();
}

void SphSolver::start() {
  cloud_ = starting_cloud(setup_);
  for (const std::uint32_t i : in_order(cloud_, ParticleKind::wall)) wall_.push_back(cloud_.at(i));
  const StandingBodies& bodies = setup_.bodies();
  if (past_bodies()) by_vorticity_ = {*bodies.shape(), wall_, bodies.nodes_of_each()};
  stencils_.renew(cloud_, setup_.operators);
  setup_.periodic ? start_periodic_flow() : start_past_body();
  look();
  on_each_ = frame_forces();
  add_up_forces(far_field_.impulse());
  measure();
}

void SphSolver::start_past_body() {
  // By Kelvin's theorem: no vorticity comes from nowhere.
  const double vortices =
      setup_.initial ? add_initial_vortices(cloud_, *setup_.initial, setup_.centre) : 0;
  start_potential_flow(cloud_, stencils_, setup_.operators, setup_.ambient, setup_.bodies(),
                       setup_.far_field, -vortices);
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
  if (past_bodies()) look_at_wall();
}

void SphSolver::look_at_wall() {
  far_field_.renew(cloud_, slopes_, setup_.ambient.steady, setup_.ambient.stream(time_));
  wall_vorticity_.resize(wall_.size()), wall_pressure_.resize(wall_.size());
  for (std::size_t i = 0; i < cloud_.size(); ++i)
    if (cloud_.kind[i] == ParticleKind::wall) {
      wall_vorticity_[cloud_.place[i]] = vorticity(slopes_[i]);
      wall_pressure_[cloud_.place[i]] = cloud_.p[i];
    }
  if (substeps_ > 0) return;
  // The wall still slips: its vorticity is a sheet.
  far_field_.add_sheet(cloud_);
  wall_vorticity_.clear();
}

void SphSolver::step(const tree::Phase& phase) {
  const double end = static_cast<double>(steps_ + 1) * setup_.dt;
  const double begin = time_;
  const Checkpoint before_step = checkpoint();
  Tractions before = traction_, given(before.size());
  try {
    while (time_ < end) {
      const double left = end - time_, dt = next_dt(left);
      // All that is looked at then is of this very time, as it is where a run goes on.
      substep(dt, left - dt > 1e-9 * setup_.dt ? time_ + dt : end, phase);
      const Tractions now = tractions();
      // There is none of an impulsive start.
      if (substeps_ == 1) before = now;
      for (std::size_t k = 0; k < now.size(); ++k) given[k] += dt / 2 * (before[k] + now[k]);
      before = now;
    }
  } catch (const std::bad_alloc&) {
    go_back(before_step);
    throw;
  } catch (const std::exception& failed) {
    go_back(before_step);
    throw flow::Diverged(failed.what());
  }
  traction_ = before;
  ++steps_;
  phase("output");
  renew_forces(given, end - begin);
  measure();
}

/// By what a step has given each body.
void SphSolver::renew_forces(const Tractions& given, double took) {
  const double memory = memory_of_pressure(time(), setup_.scales.length / setup_.scales.speed,
                                           1 / setup_.motion_period);
  on_each_ = frame_forces();
  Vec2 impulse = force_.impulse;
  for (std::size_t k = 0; k < on_each_.size(); ++k) {
    const Traction own = given[k];
    impulse = impulse - own.by_vorticity - own.friction;
    const flow::Force frame = on_each_[k];
    on_each_[k] = {.t = frame.t,
                   .pressure = smooth_pressure_[k](1 / took * own.pressure,
                                                   1 / took * own.by_vorticity, took, memory),
                   .friction = traction_[k].friction,
                   .frame = frame.frame,
                   .pressure_moment = 1 / took * own.pressure_moment,
                   .friction_moment = traction_[k].friction_moment,
                   .frame_moment = frame.frame_moment};
  }
  add_up_forces(impulse);
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

void SphSolver::substep(double dt, double later, const tree::Phase& phase) {
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
                                 .later = later,
                                 .ambient = setup_.ambient,
                                 .far_field = setup_.far_field ? &far_field_ : nullptr,
                                 .bodies = &setup_.bodies(),
                                 .wall_vorticity = wall_vorticity_,
                                 .tolerance = setup_.tolerance},
                                phase);
  phase("slopes");
  time_ = later, last_dt_ = dt, ++substeps_;
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

/// What drives the fluid with the bodies' centres: it acts on the centroid of each, and the
/// divergence of x_k x is 3 x_k.
std::vector<flow::Force> SphSolver::frame_forces() const {
  const StandingBodies& bodies = setup_.bodies();
  const Vec2 faster = setup_.ambient.motion.at(time()).acceleration;
  std::vector<Vec2> arms(bodies.size());  // int x dA, from the centre
  for (std::size_t i = 0; i < cloud_.size(); ++i) {
    if (cloud_.kind[i] != ParticleKind::wall) continue;
    const std::size_t k = bodies.of_node(cloud_.place[i]);
    const Vec2 x = cloud_.at(i) - bodies[k].centre;
    arms[k] += (bodies[k].spacing * dot(x, cloud_.normal(i)) / 3) * x;
  }
  std::vector<flow::Force> each;
  for (std::size_t k = 0; k < bodies.size(); ++k)
    each.push_back({.t = time(),
                    .frame = bodies[k].area * faster,
                    .frame_moment = dot(left_of(arms[k]), faster)});
  return each;
}

/// Those of each body; moments about the centre of the first.
void SphSolver::add_up_forces(Vec2 impulse) {
  force_ = on_each_.empty() ? flow::Force{.t = time()} : on_each_.front();
  force_.impulse = impulse;
  for (std::size_t k = 1; k < on_each_.size(); ++k) {
    const flow::Force& one = on_each_[k];
    const Vec2 lever = left_of(setup_.bodies()[k].centre);
    force_.pressure += one.pressure, force_.friction += one.friction, force_.frame += one.frame;
    force_.pressure_moment += one.pressure_moment + dot(lever, one.pressure);
    force_.friction_moment += one.friction_moment + dot(lever, one.friction);
    force_.frame_moment += one.frame_moment + dot(lever, one.frame);
  }
}

std::vector<flow::Force> SphSolver::forces_on_each() const {
  return on_each_.size() > 1 ? on_each_ : std::vector<flow::Force>{};
}

/// Force per unit density that the fluid puts on each body: int -p n + nu (grad u + grad u^T) n ds.
SphSolver::Tractions SphSolver::tractions() const {
  const StandingBodies& bodies = setup_.bodies();
  Tractions sums(bodies.size());
  for (std::size_t i = 0; i < cloud_.size(); ++i) {
    if (cloud_.kind[i] != ParticleKind::wall) continue;
    const std::size_t k = bodies.of_node(cloud_.place[i]);
    const Vec2 n = cloud_.normal(i), lever = left_of(cloud_.at(i) - bodies[k].centre);
    const auto& [u, v, u_before, v_before, p] = slopes_[i];
    const double ds = bodies[k].spacing, shear = u.y + v.x;
    const Vec2 push = (-ds * cloud_.p[i]) * n;
    const Vec2 rub =
        ds * setup_.ambient.nu * Vec2{2 * u.x * n.x + shear * n.y, shear * n.x + 2 * v.y * n.y};
    sums[k].pressure += push;
    sums[k].friction += rub;
    sums[k].pressure_moment += dot(lever, push);
    sums[k].friction_moment += dot(lever, rub);
  }
  if (wall_vorticity_.empty()) return sums;
  const std::vector<Vec2> by_vorticity = by_vorticity_.on_each(
      far_field_, wall_vorticity_, setup_.ambient.nu, setup_.ambient.motion.at(time_).acceleration);
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k].by_vorticity = by_vorticity[k];
  return sums;
}

}  // namespace vortree::sph
