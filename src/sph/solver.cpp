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
                 2 * setup_.ambient.motion.spin.rate * setup_.area,
                 faintest_vortex * setup_.scales.speed * setup_.scales.length) {
  start();
}

void SphSolver::start() {
  cloud_ = starting_cloud(setup_);
  for (const std::uint32_t i : in_order(cloud_, ParticleKind::wall)) wall_.push_back(cloud_.at(i));
  if (setup_.shape) by_vorticity_ = {*setup_.shape, wall_};
  stencils_.renew(cloud_, setup_.operators);
  setup_.periodic ? start_periodic_flow() : start_past_body();
  look();
  force_ = {.t = 0,
            .impulse = far_field_.impulse(),
            .frame = setup_.area * setup_.ambient.motion.at(0).acceleration};
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
  far_field_.renew(cloud_, slopes_, setup_.ambient.steady, setup_.ambient.stream(time_));
  wall_vorticity_.resize(wall_.size()), wall_pressure_.resize(wall_.size());
  for (std::size_t i = 0; i < cloud_.size(); ++i)
    if (cloud_.kind[i] == ParticleKind::wall) {
      wall_vorticity_[cloud_.place[i]] = vorticity(slopes_[i]);
      wall_pressure_[cloud_.place[i]] = cloud_.p[i];
    }
  if (substeps_ > 0) return;
  // The wall still slips: its vorticity is a sheet.
  far_field_.add_sheet(cloud_, setup_.ambient.motion.spin.rate);
  wall_vorticity_.clear();
}

void SphSolver::step(const tree::Phase& phase) {
  const double end = static_cast<double>(steps_ + 1) * setup_.dt;
  const double begin = time_;
  const Checkpoint before_step = checkpoint();
  Traction before = traction_, given{};
  try {
    while (time_ < end) {
      const double left = end - time_, dt = next_dt(left);
      // All that is looked at then is of this very time, as it is where a run goes on.
      substep(dt, left - dt > 1e-9 * setup_.dt ? time_ + dt : end, phase);
      const Traction now = traction();
      // There is none of an impulsive start.
      if (substeps_ == 1) before = now;
      given += dt / 2 * (before + now);
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
  const double took = end - begin;
  const double memory =
      memory_of_pressure(end, setup_.scales.length / setup_.scales.speed, 1 / setup_.motion_period);
  force_ = {.t = end,
            .impulse = force_.impulse - given.by_vorticity - given.friction,
            .pressure = smooth_pressure_(1 / took * given.pressure, 1 / took * given.by_vorticity,
                                         took, memory),
            .friction = before.friction,
            .frame = setup_.area * setup_.ambient.motion.at(end).acceleration,
            .pressure_moment = 1 / took * given.pressure_moment,
            .friction_moment = before.friction_moment,
            .frame_moment = moment_of_frame()};
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
                                 .wall_vorticity = wall_vorticity_,
                                 .wall_spacing = setup_.wall_spacing,
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

/// Of the force that drives the fluid with the body's centre: it acts on the centroid, and the
/// divergence of x_k x is 3 x_k.
double SphSolver::moment_of_frame() const {
  Vec2 arm;  // int x dA
  for (std::size_t i = 0; i < cloud_.size(); ++i)
    if (cloud_.kind[i] == ParticleKind::wall)
      arm += (setup_.wall_spacing * dot(cloud_.at(i), cloud_.normal(i)) / 3) * cloud_.at(i);
  return dot(left_of(arm), setup_.ambient.motion.at(time()).acceleration);
}

/// Force per unit density that the fluid puts on the body: int -p n + nu (grad u + grad u^T) n ds.
SphSolver::Traction SphSolver::traction() const {
  Traction sum{};
  for (std::size_t i = 0; i < cloud_.size(); ++i) {
    if (cloud_.kind[i] != ParticleKind::wall) continue;
    const Vec2 n = cloud_.normal(i);
    const auto& [u, v, u_before, v_before, p] = slopes_[i];
    const double ds = setup_.wall_spacing, shear = u.y + v.x;
    const Vec2 push = (-ds * cloud_.p[i]) * n;
    const Vec2 rub =
        ds * setup_.ambient.nu * Vec2{2 * u.x * n.x + shear * n.y, shear * n.x + 2 * v.y * n.y};
    sum.pressure += push;
    sum.friction += rub;
    sum.pressure_moment += dot(left_of(cloud_.at(i)), push);
    sum.friction_moment += dot(left_of(cloud_.at(i)), rub);
  }
  if (!wall_vorticity_.empty())
    sum.by_vorticity = by_vorticity_(far_field_, wall_vorticity_, setup_.ambient.nu,
                                     setup_.ambient.motion.at(time_).acceleration);
  return sum;
}

}  // namespace vortree::sph
