#include "vortex/step.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "vortex/stepping/around.hpp"
#include "vortex/stepping/release.hpp"
#include "vortex/transport/convect_strained.hpp"
#include "vortex/transport/particle_exchange.hpp"
#include "vortex/transport/random_walk.hpp"
#include "vortex/transport/spread_cores.hpp"
#include "vortex/tuning.hpp"

namespace vortree::vortex {

void stand(Problem& p, double time) {
  if (!p.moving) return;
  p.standing = p.moving->at(time);
  p.wall = &p.standing->wall;
  p.turning = p.standing->turning;
}

namespace {

/// Whether cores of free space are strained.
bool strains_freely(const Problem& p) {
  return !p.wall && p.flow.nu > 0 && p.strained_for > 0 && p.diffusion == Diffusion::core_spreading;
}

/// Splitting, with what a step spreads.
Splitting splitting_in(const Problem& p) {
  Splitting splitting = p.splitting;
  splitting.spread = 4 * p.flow.nu * p.dt;
  if (strains_freely(p))
    splitting.strained_steps = static_cast<std::uint64_t>(std::max(p.strained_for / p.dt, 1.0));
  return splitting;
}

/// Diffusion that is no core spreading.
void scatter(Blobs& blobs, const Problem& p, std::uint64_t number) {
  if (p.wall)
    throw std::invalid_argument("beside a wall vorticity diffuses by core spreading only");
  if (p.diffusion == Diffusion::random_walk)
    random_walk(blobs, p.flow.nu, p.dt, p.splitting.seed, number);
  else
    exchange_strength(blobs, p.flow.nu, p.dt, p.sigma_0, p.area);
}

/// Steps and their parts beside a wall, by the number of the step: an impulsive start changes the
/// flow as fast as it is young. What the last part makes lies on the wall as a sheet, though it has
/// spread since it came about; so forces err by how much more there is of it than a step before,
/// and the last part grows slowly.
struct Parts {
  int count = 1;
  double last = 1, others = 0;  // of a step's length

  Parts(const Problem& p, std::uint64_t number) {
    number = std::max<std::uint64_t>(number, 1);
    if (!p.wall || number >= first_substeps) return;
    count = static_cast<int>((first_substeps + number - 1) / number);
    last = static_cast<double>(number) / first_substeps;
    others = (1 - last) / (count - 1);
  }
  double length(int k) const { return k + 1 < count ? others : last; }
};

/// The problem with a step of so much of its dt, and cores and mergers of a step of the last part.
Problem part_of(const Problem& whole, double length, double last) {
  Problem p = whole;
  p.dt *= length;
  p.sigma_0 *= std::sqrt(length);
  for (double* scale : {&p.splitting.sigma_max, &p.merging.sigma_max, &p.merging.tolerance})
    *scale *= std::sqrt(last);
  return p;
}

}  // namespace

Wake start(Blobs& blobs, const Problem& p) {
  // The first sheet is as old as no time at all: a thin core, whose full age comes with the first
  // step.
  const double dt = p.dt * Parts(p, 1).last;
  const double core = std::sqrt(0.02 * 4 * p.flow.nu * dt);
  return p.wall ? cancel_slip(blobs, WallPoints(), p, p.time, core, true) : Wake{};
}

namespace {

/// How the axes of the body turn in a step.
TurningAxes turning_axes(const Problem& p) {
  if (!p.flow.motion.turns()) return {};
  return [&p](double after) { return p.flow.turned(p.time, after); };
}

/// The wall as it goes on in a step.
WallOnItsWay wall_on_its_way(Problem& p) {
  if (!p.wall) return {};
  const auto shape_after = [&p](double after) {
    stand(p, p.time + after);
    return &p.wall->shape();
  };
  const auto turned = [&p](double arc, double after) {
    const std::size_t body = p.wall->ring_at(arc);
    return p.flow.own_at(body, p.time + after).angle - p.flow.own_at(body, p.time).angle;
  };
  return {shape_after, turned};
}

/// Carries all for a step. Those that drift go with the stream alone; what the others would have
/// carried them beyond it belongs to the moment of what has left all the same: so much do they
/// carry the others and the sheet the other way, and that is no force on the body. The wall goes on
/// to where it is at the end.
///
/// found    wall points nearest to the blobs' centres
/// returns  those of where they have come to
WallPoints carry(Blobs& blobs, Problem& p, bool strains, const WallPoints& found) {
  const Vec2 way = p.flow.way(p.time, p.dt);
  const std::size_t inside = blobs.size();
  const Blobs drifting = felt(p);
  append(blobs, drifting);
  const auto velocity = [&](const Blobs& b, const FoldedBlobs& at, double after, Gradients* g) {
    stand(p, p.time + after);
    return advecting_velocity(b, at, p, p.time + after, g);
  };
  WallPoints to =
      convect(blobs, velocity, wall_on_its_way(p), p.scheme, p.dt, strains, found, turning_axes(p));
  const Turn turn(-p.flow.turned(p.time, p.dt));
  p.outflow.moment = turn(p.outflow.moment);
  for (std::size_t i = 0; i < drifting.size(); ++i)
    p.outflow.moment +=
        drifting.gamma[i] * (blobs.centre(inside + i) - turn(drifting.centre(i)) - way);
  blobs.resize(inside);
  p.outflow.drift(way);
  if (p.box) drift(p.drifting, way, 4 * p.flow.nu * p.dt, *p.box, turn);
  return to;
}

/// Carries all of free space for a step, and strains their cores.
void carry_strained(Blobs& blobs, const Problem& p) {
  const auto velocity = [&](const Blobs& parts, double after, Gradients& gradients) {
    return advecting_velocity(parts, {parts.x, parts.y, parts.sigma}, p, p.time + after,
                              &gradients);
  };
  convect_strained(blobs, velocity, p.scheme, p.dt);
}

/// Radius around the origin within which the wall lies.
double radius_of(const Wall& wall) {
  double square = 0;
  for (const Vec2 at : wall.middles()) square = std::max(square, dot(at, at));
  return std::sqrt(square);
}

/// What has left the box drifts on, and comes back as blobs where the stream brings it back.
void exchange_with_drifting(Blobs& blobs, const Blobs& left, Problem& p) {
  const Blobs back = come_back(p.drifting, *p.box);
  p.outflow.take_back(account_of(back));
  append(blobs, back);
  take(p.drifting, left);
  merge_drifting(p.drifting, radius_of(*p.wall), p.unfelt);
}

void let_go(Blobs& blobs, Problem& p) {
  if (p.box) {
    const Blobs left = take_outside(blobs, *p.box);
    p.outflow = p.outflow + account_of(left);
    if (p.wall) exchange_with_drifting(blobs, left, p);
  }
  if (p.faintest > 0) p.outflow = p.outflow + remove_faint(blobs, p.faintest);
}

/// Splitting and merging, counted.
void adapt(Blobs& blobs, const Problem& p, std::uint64_t number, const WallPoints& found,
           StepCounts& counts, const tree::Phase& phase) {
  const body::Shape* shape = p.wall ? &p.wall->shape() : nullptr;
  phase("split");
  AdaptedBlobs adapted = split_apart(blobs, splitting_in(p), shape, number, found);
  counts.laid = adapted.laid;
  counts.split = adapted.split;
  counts.beside_wall = adapted.at_wall.size();
  const std::size_t before = adapted.all.size();
  phase("merge");
  merge_close(adapted, p.merging);
  counts.merged = before - adapted.all.size();
  if (adapted.all.size() > p.most_blobs) throw Multiplied(adapted.all.size());
  blobs = pack(adapted, shape);
}

StepCounts operator+(StepCounts a, const StepCounts& b) {
  for (const auto count : {&StepCounts::released, &StepCounts::laid, &StepCounts::split,
                           &StepCounts::beside_wall, &StepCounts::merged})
    a.*count += b.*count;
  return a;
}

Wake step_in_one(Blobs& blobs, Problem p, std::uint64_t number, const tree::Phase& phase) {
  stand(p, p.time);
  const auto shape = [&] { return p.wall ? &p.wall->shape() : nullptr; };
  Wake wake;
  phase("convect");
  const bool spreads = p.flow.nu > 0 && p.diffusion == Diffusion::core_spreading;
  WallPoints found;
  const auto spread = [&] { found = spread_cores(blobs, p.flow.nu, p.dt / 2, shape(), found); };
  if (spreads) spread();
  if (strains_freely(p))
    carry_strained(blobs, p);
  else
    found = carry(blobs, p, spreads && p.wall, found);
  stand(p, p.time + p.dt);
  if (spreads)
    spread();
  else if (p.flow.nu > 0)
    scatter(blobs, p, number);
  if (p.wall) {
    phase("wall");
    wake = cancel_slip(blobs, found, p, p.time + p.dt, p.sigma_0, false);
    wake.counts.released = p.wall->panels();
  }
  if (spreads) adapt(blobs, p, number, found, wake.counts, phase);
  let_go(blobs, p);
  wake.outflow = p.outflow;
  wake.drifting = std::move(p.drifting);
  return wake;
}

}  // namespace

Wake step(Blobs& blobs, const Problem& whole, std::uint64_t number, const tree::Phase& phase) {
  const Parts parts(whole, number);
  Wake wake;
  wake.outflow = whole.outflow;
  wake.drifting = whole.drifting;
  std::vector<Load> pressure(whole.wall ? whole.wall->rings().size() : 0);
  double time = whole.time;
  std::vector<double> slope(whole.wall ? whole.wall->panels() : 0);
  for (int k = 0; k < parts.count; ++k) {
    Problem p = part_of(whole, parts.length(k), parts.last);
    p.time = time;
    p.outflow = wake.outflow;
    p.drifting = wake.drifting;
    const StepCounts before = wake.counts;
    wake = step_in_one(blobs, p, number + (static_cast<std::uint64_t>(k) << 32), phase);
    wake.counts = before + wake.counts;
    for (std::size_t body = 0; body < pressure.size(); ++body)
      pressure[body] += parts.length(k) * wake.pressure[body];
    add(slope, parts.length(k), wake.pressure_slope);
    time += p.dt;
  }
  wake.pressure = std::move(pressure);
  wake.pressure_slope = std::move(slope);
  return wake;
}

MovingBlobs moving(const Blobs& blobs, const Problem& p, WithSlope wanted) {
  MovingBlobs all{with_drifting(blobs, p), {}, Velocities()};
  if (!p.wall) all.blobs = Halves(all.blobs).parts;
  all.at = fold(all.blobs, p.wall ? &p.wall->shape() : nullptr);
  all.u = advecting_velocity(all.blobs, all.at, p, p.time,
                             wanted == WithSlope::yes ? &all.slope : nullptr);
  return all;
}

Velocities velocity_at(tree::Points points, const Blobs& blobs, const Problem& p) {
  const Blobs all = with_drifting(blobs, p);
  const FoldedBlobs at = fold(all, p.wall ? &p.wall->shape() : nullptr);
  if (p.wall) return with_sheet(points, all, at, p, p.time).u;
  Velocities u(points.size());
  const Blobs parts = Halves(all).parts;
  fmm::Plan({parts.x, parts.y, parts.gamma, parts.sigma}, at_points(p.sums))
      .velocity(fmm::Targets{points.x, points.y, {}}, u.u, u.v);
  add_stream(u, p.flow.stream_at(p.time));
  return u;
}

Acting acting(const Blobs& blobs, const Problem& p) {
  const Blobs all = with_drifting(blobs, p);
  if (!p.wall) {
    Blobs parts = Halves(all).parts;
    return {
        std::move(parts.x), std::move(parts.y), std::move(parts.gamma), std::move(parts.sigma), {}};
  }
  FoldedBlobs at = fold(all, &p.wall->shape());
  std::vector<double> sheet = with_sheet({}, all, at, p, p.time).sheet;
  return {std::move(at.x), std::move(at.y), all.gamma, std::move(at.sigma),
          with_turning(std::move(sheet), p, Around(p, p.time))};
}

}  // namespace vortree::vortex
