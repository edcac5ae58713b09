#include "vortex/step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "base/ordered_sum.hpp"
#include "flow/near_wake.hpp"
#include "fmm/plan.hpp"
#include "vortex/cores/folded_core.hpp"
#include "vortex/transport/convect_strained.hpp"
#include "vortex/transport/particle_exchange.hpp"
#include "vortex/transport/random_walk.hpp"
#include "vortex/transport/spread_cores.hpp"
#include "vortex/tuning.hpp"
#include "vortex/wall/forces.hpp"

namespace vortree::vortex {
namespace {

double total(std::span<const double> gamma) {
  return ordered_sum(gamma.size(), [&](std::size_t first, std::size_t last) {
    return std::reduce(gamma.begin() + first, gamma.begin() + last);
  });
}

void add_stream(Velocities& u, Vec2 stream) {
  for (double& a : u.u) a += stream.x;
  for (double& a : u.v) a += stream.y;
}

/// What surrounds the blobs at one time: the stream, and how fast the body turns.
struct Around {
  Vec2 stream;
  double rate;

  Around(const Problem& p, double time)
      : stream(p.flow.stream_at(time)), rate(p.turning ? p.flow.motion.at(time).rate : 0) {}

  double of_body(const Problem& p) const { return p.turning ? rate * p.turning->circulation : 0; }
};

void add(std::vector<double>& sum, double weight, std::span<const double> of) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * of[i];
}

/// The slip at the wall of all that moves fluid but the sheet.
std::vector<double> slip_of(const Blobs& blobs, const FoldedBlobs& at, const Velocities& at_samples,
                            const Problem& p, const Around& around) {
  std::vector<double> slip = p.wall->slip(around.stream, at_samples, at, blobs.gamma);
  if (p.turning) add(slip, around.rate, p.turning->slip);
  return slip;
}

/// The sheet that moves fluid, and with it that of a body which turns.
std::vector<double> with_turning(std::vector<double> sheet, const Problem& p,
                                 const Around& around) {
  if (p.turning) add(sheet, around.rate, p.turning->sheet);
  return sheet;
}

Blobs felt(const Problem& p) {
  return p.box ? felt(p.drifting, *p.box) : Blobs{};
}

void append(Blobs& blobs, const Blobs& more) {
  for (std::size_t i = 0; i < more.size(); ++i)
    blobs.append(more.centre(i), more.gamma[i], more.core(i));
}

/// The blobs, and after them those that have left and are felt.
Blobs with_drifting(const Blobs& blobs, const Problem& p) {
  Blobs all = blobs;
  append(all, felt(p));
  return all;
}

/// Of all sheets, that which leaves no circulation in fluid and body together. `all` has those that
/// drift, too.
double sheet_circulation(const Blobs& all, const Problem& p, const Around& around) {
  return -total(all.gamma) - (p.outflow.gamma - total(felt(p).gamma)) - around.of_body(p);
}

fmm::Sources as_sources(const Blobs& blobs, const FoldedBlobs& at) {
  return {at.x, at.y, blobs.gamma, at.sigma};
}

/// A point has no core of its own that could enter a mean.
fmm::Options at_points(fmm::Options sums) {
  sums.cores = fmm::Cores::source;
  return sums;
}

/// Velocity of the blobs at their folded centroids, with stream and wall; and its gradient, if
/// wanted, without the sheet's.
Velocities advecting_velocity(const Blobs& blobs, const FoldedBlobs& at, const Problem& p,
                              double time, Gradients* gradients) {
  const Around around(p, time);
  Velocities u(blobs.size());
  Velocities at_samples(p.wall ? 2 * p.wall->panels() : 0);
  FoldedBlobs advecting = at;
  if (p.advecting_cores != 1)
    for (double& sigma : advecting.sigma) sigma *= p.advecting_cores;
  const fmm::Sources sources = as_sources(blobs, advecting);
  const tree::Points samples = p.wall ? p.wall->samples() : tree::Points{};
  const fmm::Plan plan(sources, p.sums);
  if (gradients) {
    *gradients = Gradients(blobs.size());
    plan.velocity_and_gradient(u.u, u.v, gradients->ux, gradients->uy, gradients->vx);
  } else {
    plan.velocity(u.u, u.v);
  }
  plan.velocity_bare(samples, at_samples.u, at_samples.v);
  add_stream(u, around.stream);
  if (p.wall) {
    const auto slip = slip_of(blobs, at, at_samples, p, around);
    const auto sheet = p.wall->sheet(slip, sheet_circulation(blobs, p, around));
    p.wall->add_velocity(with_turning(sheet, p, around), at_points(p.sums), {at.x, at.y}, u,
                         at.wall);
  }
  return u;
}

/// Slip at the wall, the sheet that cancels it there, and velocities at points of the fluid.
struct AtRest {
  std::vector<double> slip, sheet;
  Velocities u;
};

/// The sheet that cancels the slip which the blobs leave at the wall, and the velocity of stream,
/// blobs and sheet together.
AtRest with_sheet(tree::Points points, const Blobs& blobs, const FoldedBlobs& at, const Problem& p,
                  double time) {
  const Around around(p, time);
  AtRest result{{}, {}, Velocities(points.size())};
  Velocities at_samples(2 * p.wall->panels());
  const fmm::Plan plan(as_sources(blobs, at), at_points(p.sums));
  plan.velocity_bare(p.wall->samples(), at_samples.u, at_samples.v);
  plan.velocity(fmm::Targets{points.x, points.y, {}}, result.u.u, result.u.v);
  result.slip = slip_of(blobs, at, at_samples, p, around);
  result.sheet = p.wall->sheet(result.slip, sheet_circulation(blobs, p, around));
  add_stream(result.u, around.stream);
  p.wall->add_velocity(with_turning(result.sheet, p, around), at_points(p.sums), points, result.u);
  return result;
}

/// A sheet that is itself again, to the fourth power of a panel, when it has been smoothed along
/// the wall by so much variance beyond its own, in squares of a panel's length.
std::vector<double> sharpened(std::span<const double> sheet, double variance) {
  const std::size_t n = sheet.size();
  std::vector<double> result(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double around = sheet[(i + 1) % n] + sheet[(i + n - 1) % n];
    result[i] = sheet[i] - variance / 2 * (around - 2 * sheet[i]);
  }
  return result;
}

/// What a sheet becomes: blobs of this core across the wall; along it as long as a panel, which
/// leaves a ripple of 1e-4 between neighbors.
Blobs released(std::span<const double> sheet, const Wall& wall, double core) {
  const double b = wall.panel_length(), along = std::max(core, b);
  const Covariance v{core * core / 2, 0, along * along / 2};
  const std::vector<double> sharp = sharpened(sheet, (v.tt - v.nn) / (b * b));
  Blobs blobs;
  for (std::size_t i = 0; i < wall.panels(); ++i) {
    const body::WallPoint at = wall.shape().nearest(wall.middle(i));
    blobs.append(wall.middle(i) - folded::sag(v.nn, v.tt, at.curvature) * at.normal, sharp[i] * b,
                 core_of(v, at.normal));
  }
  return blobs;
}

/// Whether a core is no wider than half of what the wall is bent by anywhere.
bool thin_beside(const Wall& wall, double core) {
  return std::ranges::all_of(wall.middles(), [&](Vec2 at) {
    return std::abs(wall.shape().nearest(at).curvature) * core <= 0.5;
  });
}

/// The sheet that cancels the slip from where it acts once it is released, some way m off the wall:
/// the sheet at the wall would leave the share n m/R of mode n of a circle's slip, this one its
/// square. Around an edge sharper than the core no such sheet is to be had.
std::vector<double> as_released(const AtRest& at_rest, const Problem& p, double core) {
  if (!thin_beside(*p.wall, core)) return at_rest.sheet;
  std::vector<double> sheet = at_rest.sheet;
  const Blobs fresh = released(sheet, *p.wall, core);
  const FoldedBlobs at = fold(fresh, &p.wall->shape());
  Velocities at_samples(2 * p.wall->panels());
  fmm::Plan(as_sources(fresh, at), at_points(p.sums))
      .velocity_bare(p.wall->samples(), at_samples.u, at_samples.v);
  std::vector<double> left = p.wall->slip({}, at_samples, at, fresh.gamma);
  for (std::size_t i = 0; i < left.size(); ++i) left[i] += at_rest.slip[i];
  const std::vector<double> more = p.wall->sheet(left, 0);
  for (std::size_t i = 0; i < more.size(); ++i) sheet[i] += more[i];
  return sheet;
}

/// What a body that turns has to do with impulse and pressure in the step that ends at `time`, all
/// told in axes that do not turn. Its wall is driven by pressure beyond what the frame is, and the
/// frame's own share (Flow::motion) is that of the body's centroid, not of its centre.
void add_turning(Wake& wake, const Problem& p, double time) {
  const body::Kinematics now = p.flow.motion.at(time), before = p.flow.motion.at(time - p.dt),
                         between = p.flow.motion.at(time - p.dt / 2);
  const Vec2 arm = 0.5 * p.turning->moment;  // of the centroid, times the area
  const Turn turn(now.angle);
  const std::vector<double> driven =
      gained_along_wall(*p.wall, now.rate - before.rate, between.rate, p.dt);
  wake.pressure =
      Turn(between.angle)(wake.pressure + pressure_force(driven, *p.wall, p.dt)) -
      1 / p.dt * (now.rate * turn(left_of(arm)) - before.rate * Turn(before.angle)(left_of(arm)));
  wake.pressure_moment += pressure_moment(driven, *p.wall, p.dt);
  add(wake.pressure_slope, -1 / p.dt, driven);
  wake.friction_moment -= 2 * p.flow.nu * now.rate * p.turning->circulation;
  wake.moment = turn(wake.moment + now.rate * p.turning->moment);
  wake.friction = turn(wake.friction);
}

/// `impulsive`: the slip has come about at once, and so has the sheet, on the wall.
///
/// found  wall points nearest to the blobs' centres
Wake cancel_slip(Blobs& blobs, const WallPoints& found, const Problem& p, double time, double core,
                 bool impulsive) {
  const Blobs all = with_drifting(blobs, p);
  const FoldedBlobs at = fold(all, &p.wall->shape(), found);
  Wake wake;
  const bool stream = dot(p.flow.stream, p.flow.stream) > 0 && !p.flow.motion.moves();
  const flow::WakeLine line =
      stream ? flow::wake_line(p.wall->middles(), p.wall->shape(), p.flow.stream)
             : flow::WakeLine{};
  const AtRest at_rest = with_sheet(line.points(), all, at, p, time);
  wake.sheet = impulsive ? at_rest.sheet : as_released(at_rest, p, core);
  const Blobs fresh = released(wake.sheet, *p.wall, core);
  wake.bubble_length = flow::bubble_length(line, at_rest.u.u, at_rest.u.v);
  const Vec2 of_sheet =
      impulsive ? p.wall->first_moment(wake.sheet) : invariants(fresh, &p.wall->shape()).moment;
  wake.moment = invariants(blobs, at).moment + of_sheet + p.outflow.moment;
  WallShear shear = wall_shear(blobs, wake.sheet, *p.wall, p.flow.nu, p.dt, p.sigma_0, found);
  wake.wall_vorticity = std::move(shear.vorticity);
  wake.friction = shear.friction;
  wake.friction_moment = shear.moment;
  wake.pressure = pressure_force(wake.sheet, *p.wall, p.dt);
  wake.pressure_moment = pressure_moment(wake.sheet, *p.wall, p.dt);
  wake.pressure_slope.resize(p.wall->panels());
  add(wake.pressure_slope, -1 / p.dt, wake.sheet);
  if (p.turning) add_turning(wake, p, time);
  append(blobs, fresh);
  return wake;
}

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

/// Carries all for a step. Those that drift go with the stream alone; what the others would have
/// carried them beyond it belongs to the moment of what has left all the same: so much do they
/// carry the others and the sheet the other way, and that is no force on the body.
///
/// found    wall points nearest to the blobs' centres
/// returns  those of where they have come to
WallPoints carry(Blobs& blobs, Problem& p, const body::Shape* shape, bool strains,
                 const WallPoints& found) {
  const Vec2 way = p.flow.way(p.time, p.dt);
  const std::size_t inside = blobs.size();
  const Blobs drifting = felt(p);
  append(blobs, drifting);
  const auto velocity = [&](const Blobs& b, const FoldedBlobs& at, double after, Gradients* g) {
    return advecting_velocity(b, at, p, p.time + after, g);
  };
  WallPoints to = convect(blobs, velocity, shape, p.scheme, p.dt, strains, found, turning_axes(p));
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
  const body::Shape* shape = p.wall ? &p.wall->shape() : nullptr;
  Wake wake;
  phase("convect");
  const bool spreads = p.flow.nu > 0 && p.diffusion == Diffusion::core_spreading;
  WallPoints found;
  const auto spread = [&] { found = spread_cores(blobs, p.flow.nu, p.dt / 2, shape, found); };
  if (spreads) spread();
  if (strains_freely(p))
    carry_strained(blobs, p);
  else
    found = carry(blobs, p, shape, spreads && shape, found);
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
  Vec2 pressure;
  double pressure_moment = 0, time = whole.time;
  std::vector<double> slope(whole.wall ? whole.wall->panels() : 0);
  for (int k = 0; k < parts.count; ++k) {
    Problem p = part_of(whole, parts.length(k), parts.last);
    p.time = time;
    p.outflow = wake.outflow;
    p.drifting = wake.drifting;
    const StepCounts before = wake.counts;
    wake = step_in_one(blobs, p, number + (static_cast<std::uint64_t>(k) << 32), phase);
    wake.counts = before + wake.counts;
    pressure += parts.length(k) * wake.pressure;
    pressure_moment += parts.length(k) * wake.pressure_moment;
    add(slope, parts.length(k), wake.pressure_slope);
    time += p.dt;
  }
  wake.pressure = pressure;
  wake.pressure_moment = pressure_moment;
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
