#include "vortex/step.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "vortex/forces.hpp"
#include "vortex/in_parts.hpp"
#include "vortex/near_wake.hpp"
#include "vortex/particle_exchange.hpp"
#include "vortex/random_walk.hpp"
#include "vortex/spread_cores.hpp"

namespace vortree::vortex {
namespace {

double total(std::span<const double> gamma) {
  return sum_in_parts(gamma.size(), [&](std::size_t first, std::size_t last) {
    return std::reduce(gamma.begin() + first, gamma.begin() + last);
  });
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

/// A sheet at the wall, and velocities at points of the fluid.
struct AtRest {
  std::vector<double> sheet;
  Velocities u;
};

/// The sheet that cancels the slip which the blobs leave at the wall, and the velocity of stream,
/// blobs and sheet together.
AtRest with_sheet(tree::Points points, const Blobs& blobs, const Acting& at, const Problem& p,
                  Vec2 stream) {
  AtRest result{{}, Velocities(points.size())};
  Velocities at_samples(2 * p.wall->panels());
  p.velocity->upon_both(as_sources(blobs, at), p.wall->samples(), at_samples, points, result.u);
  const auto slip = p.wall->slip(stream, at_samples, at, blobs.gamma);
  result.sheet = p.wall->sheet(slip, -total(blobs.gamma) - p.retired.gamma);
  add_stream(result.u, stream);
  p.wall->add_velocity(result.sheet, *p.velocity, points, result.u);
  return result;
}

void release(Blobs& blobs, std::span<const double> sheet, const Wall& wall, double core) {
  for (std::size_t i = 0; i < wall.panels(); ++i)
    blobs.append(wall.middle(i), sheet[i] * wall.panel_length(), core);
}

Wake cancel_slip(Blobs& blobs, const Problem& p, double time, double core) {
  const Acting at = acting(blobs, &p.wall->shape());
  Wake wake;
  const WakeLine line =
      dot(p.flow.stream, p.flow.stream) > 0 ? wake_line(*p.wall, p.flow.stream) : WakeLine{};
  AtRest at_rest = with_sheet(line.points(), blobs, at, p, p.flow.stream_at(time));
  wake.sheet = std::move(at_rest.sheet);
  wake.bubble_length = bubble_length(line, at_rest.u);
  wake.moment = invariants(blobs, at).moment + p.wall->first_moment(wake.sheet) + p.retired.moment;
  wake.wall_vorticity = wall_vorticity(blobs, wake.sheet, *p.wall, p.flow.nu, p.dt, p.sigma_0);
  wake.pressure = pressure_force(wake.sheet, *p.wall, p.dt);
  wake.friction = friction_force(blobs, wake.sheet, *p.wall, p.flow.nu, p.dt, p.sigma_0);
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
  wake.retired = p.retired;
  if (p.box) wake.retired = wake.retired + retire(blobs, *p.box);
  if (p.faintest > 0) wake.retired = wake.retired + retire(blobs, p.faintest);
  wake.retired.drift(p.flow.way(p.time, p.dt));
  return wake;
}

Velocities velocity_at(tree::Points points, const Blobs& blobs, const Problem& p) {
  const Acting at = acting(blobs, p.wall ? &p.wall->shape() : nullptr);
  const Vec2 stream = p.flow.stream_at(p.time);
  if (p.wall) return with_sheet(points, blobs, at, p, stream).u;
  Velocities u(points.size());
  p.velocity->upon(as_sources(blobs, at), points, u);
  add_stream(u, stream);
  return u;
}

}  // namespace vortree::vortex
