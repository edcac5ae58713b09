#include "vortex/step.hpp"

#include <cmath>
#include <stdexcept>

#include "vortex/forces.hpp"
#include "vortex/particle_exchange.hpp"
#include "vortex/random_walk.hpp"
#include "vortex/spread_cores.hpp"

namespace vortree::vortex {
namespace {

double total(std::span<const double> gamma) {
  double sum = 0;
  for (double g : gamma) sum += g;
  return sum;
}

void add_stream(Velocities& u, Vec2 stream) {
  for (double& a : u.u) a += stream.x;
  for (double& a : u.v) a += stream.y;
}

fmm::Blobs as_sources(const Blobs& blobs, const Acting& at) {
  return {at.x, at.y, blobs.gamma, at.sigma};
}

/// Velocity of the blobs at their acting positions, with stream and wall.
Velocities carrying(const Blobs& blobs, const Acting& at, const Problem& p, Vec2 stream) {
  Velocities u(blobs.size());
  Velocities at_samples(p.wall ? 2 * p.wall->panels() : 0);
  Acting carrying = at;
  if (p.carrying_cores != 1)
    for (double& sigma : carrying.sigma) sigma *= p.carrying_cores;
  p.velocity->upon_itself_and(as_sources(blobs, carrying),
                              p.wall ? p.wall->samples() : tree::Points{}, u, at_samples);
  add_stream(u, stream);
  if (p.wall) {
    const auto slip = p.wall->slip(stream, at_samples, at, blobs.gamma);
    const auto sheet = p.wall->sheet(slip, -total(blobs.gamma) - p.retired.gamma);
    p.wall->add_velocity(sheet, *p.velocity, {at.x, at.y}, u);
  }
  return u;
}

/// The sheet that cancels the slip which the blobs leave at the wall.
std::vector<double> cancelling_sheet(const Blobs& blobs, const Acting& at, const Problem& p,
                                     Vec2 stream) {
  Velocities at_samples(2 * p.wall->panels());
  p.velocity->upon({at.x, at.y, blobs.gamma, {}}, p.wall->samples(), at_samples);
  const auto slip = p.wall->slip(stream, at_samples, at, blobs.gamma);
  return p.wall->sheet(slip, -total(blobs.gamma) - p.retired.gamma);
}

void release(Blobs& blobs, std::span<const double> sheet, const Wall& wall, double core) {
  for (std::size_t i = 0; i < wall.panels(); ++i)
    blobs.append(wall.middle(i), sheet[i] * wall.panel_length(), core);
}

Wake cancel_slip(Blobs& blobs, const Problem& p, double time, double core) {
  const Acting at = acting(blobs, &p.wall->shape());
  Wake wake;
  wake.sheet = cancelling_sheet(blobs, at, p, p.flow.stream_at(time));
  wake.moment = invariants(blobs, &p.wall->shape()).moment + p.wall->first_moment(wake.sheet) +
                p.retired.moment;
  wake.wall_vorticity = wall_vorticity(blobs, wake.sheet, *p.wall, p.flow.nu, p.dt);
  wake.pressure = pressure_force(wake.sheet, *p.wall, p.dt);
  wake.friction = friction_force(blobs, wake.sheet, *p.wall, p.flow.nu, p.dt);
  release(blobs, wake.sheet, *p.wall, core);
  return wake;
}

void diffuse(Blobs& blobs, const Problem& p, std::uint64_t number) {
  if (p.diffusion == Diffusion::core_spreading) return spread_cores(blobs, p.flow.nu, p.dt);
  if (p.wall)
    throw std::invalid_argument("beside a wall vorticity diffuses by core spreading only");
  if (p.diffusion == Diffusion::random_walk)
    random_walk(blobs, p.flow.nu, p.dt, p.splitting.seed, number);
  else
    exchange_strength(blobs, p.flow.nu, p.dt, p.sigma_0, p.area);
}

}  // namespace

Wake start(Blobs& blobs, const Problem& p) {
  // The first sheet is as old as no time at all: a thin core, whose full age comes with the first
  // step.
  return p.wall ? cancel_slip(blobs, p, p.time, std::sqrt(0.02 * 4 * p.flow.nu * p.dt)) : Wake{};
}

Wake step(Blobs& blobs, const Problem& p, std::uint64_t number, const Phase& phase) {
  const Shape* shape = p.wall ? &p.wall->shape() : nullptr;
  Wake wake;
  phase("convect");
  convect(
      blobs,
      [&](const Blobs& b, const Acting& at, double after) {
        return carrying(b, at, p, p.flow.stream_at(p.time + after));
      },
      shape, p.scheme, p.dt);
  if (p.flow.nu > 0) diffuse(blobs, p, number);
  if (p.wall) {
    phase("wall");
    wake = cancel_slip(blobs, p, p.time + p.dt, p.sigma_0);
  }
  if (p.flow.nu > 0 && p.diffusion == Diffusion::core_spreading) {
    phase("split");
    Parts parts = split_apart(blobs, p.splitting, shape, number);
    phase("merge");
    merge_close(parts, p.merging);
    blobs = settled(parts, shape);
  }
  if (p.box) {
    wake.retired = p.retired + retire(blobs, *p.box);
    wake.retired.drift(p.flow.way(p.time, p.dt));
  }
  return wake;
}

Velocities velocity_at(tree::Points points, const Blobs& blobs, const Problem& p) {
  const Acting at = acting(blobs, p.wall ? &p.wall->shape() : nullptr);
  Velocities u(points.size());
  p.velocity->upon(as_sources(blobs, at), points, u);
  const Vec2 stream = p.flow.stream_at(p.time);
  add_stream(u, stream);
  if (p.wall) p.wall->add_velocity(cancelling_sheet(blobs, at, p, stream), *p.velocity, points, u);
  return u;
}

}  // namespace vortree::vortex
