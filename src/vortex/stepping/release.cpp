#include "vortex/stepping/release.hpp"

#include <algorithm>
#include <cmath>

#include "flow/near_wake.hpp"
#include "vortex/cores/folded_core.hpp"
#include "vortex/stepping/around.hpp"
#include "vortex/wall/forces.hpp"

namespace vortree::vortex {
namespace {

/// A sheet that is itself again, to the fourth power of a panel, when it has been smoothed along
/// the wall by variances v: gamma - (v gamma)''/2, told by fluxes between panels of lengths b.
/// All are of one body.
std::vector<double> sharpened(std::span<const double> sheet, std::span<const double> b,
                              std::span<const double> v) {
  const std::size_t n = sheet.size();
  const double most = std::ranges::max(v);
  std::vector<double> result(sheet.begin(), sheet.end());
  for (std::size_t i = 0; most > 0 && i < n; ++i) {
    const auto way = [&](std::size_t k) { return 2 * b[i] / (b[i] + b[k]); };
    const auto moves = [&](std::size_t k) { return v[k] / most * sheet[k]; };
    const std::size_t next = (i + 1) % n, last = (i + n - 1) % n;
    const double around = way(next) * moves(next) + way(last) * moves(last);
    result[i] -= most / (b[i] * b[i]) / 2 * (around - (way(next) + way(last)) * moves(i));
  }
  return result;
}

/// What the sheet of a body becomes: blobs of this core across the wall; along it as long as a
/// panel, which leaves a ripple of 1e-4 between neighbors.
void release(std::span<const double> sheet, const Wall& wall, const Ring& ring, double core,
             Blobs& blobs) {
  const auto covariance = [&](double b) {
    const double along = std::max(core, b);
    return Covariance{core * core / 2, 0, along * along / 2};
  };
  const std::span<const double> lengths = wall.panel_lengths();
  std::vector<double> wider;
  for (const double b : ring.of(lengths)) wider.push_back(covariance(b).tt - covariance(b).nn);
  const std::vector<double> sharp = sharpened(ring.of(sheet), ring.of(lengths), wider);
  for (std::size_t i = ring.first; i < ring.end(); ++i) {
    const Covariance v = covariance(lengths[i]);
    const body::WallPoint at = wall.shape().nearest(wall.middle(i));
    blobs.append(wall.middle(i) - folded::sag(v.nn, v.tt, at.curvature) * at.normal,
                 sharp[i - ring.first] * lengths[i], core_of(v, at.normal));
  }
}

Blobs released(std::span<const double> sheet, const Wall& wall, double core) {
  Blobs blobs;
  for (const Ring& ring : wall.rings()) release(sheet, wall, ring, core, blobs);
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

/// How a body goes in the frame, and what its turning needs.
struct Going {
  Vec2 velocity, of_centroid;  // the arm from centre to centroid, times the area
  double rate, area;

  Going(std::size_t k, const Problem& p, double now, double time)
      : velocity(p.flow.own_at(k, time).velocity),
        rate(p.flow.rate(k, time)),
        area(p.wall->area(k)) {
    const double since = p.flow.own_at(k, time).angle - p.flow.own_at(k, now).angle;
    if (!p.turning.empty()) of_centroid = Turn(since)(p.turning[k].of_centroid);
  }
  /// Of the centroid, times the area.
  Vec2 flux() const { return area * velocity + rate * left_of(of_centroid); }
};

/// What a body's own motion has to do with pressure in the step that ends at `time`, all told in
/// axes that do not turn. Its wall is driven by pressure beyond what the frame is, and the frame's
/// own share (Flow::motion) is that of the body's centroid, not of its centre.
void add_own_motion(std::size_t k, Wake& wake, const Problem& p, double time) {
  const Going now(k, p, time, time), before(k, p, time, time - p.dt);
  const auto axes = [&](double t) { return Turn(p.flow.motion.at(t).angle); };
  const std::vector<double> driven =
      gained_along_wall(*p.wall, p.wall->rings()[k],
                        {now.velocity - before.velocity, now.rate - before.rate,
                         p.flow.rate(k, time - p.dt / 2), p.dt});
  Load& pressure = wake.pressure[k];
  pressure += pressure_loads(driven, *p.wall, p.dt)[k];
  // A place of the wall has gone round while it gathered what pressure drove off it.
  const Turn back(p.flow.own_at(k, time - p.dt / 2).angle - p.flow.own_at(k, time).angle);
  pressure.force = axes(time - p.dt / 2)(back(pressure.force)) -
                   1 / p.dt * (axes(time)(now.flux()) - axes(time - p.dt)(before.flux()));
  add(wake.pressure_slope, -1 / p.dt, driven);
  wake.friction[k].force = axes(time)(wake.friction[k].force);
  if (p.turning.empty()) return;
  wake.friction[k].moment -= 2 * p.flow.nu * now.rate * p.turning[k].circulation;
  wake.moment += now.rate * p.turning[k].moment;
}

/// Whether bodies move other than with a frame that does not turn.
bool own_motions(const Problem& p) {
  return !p.turning.empty() ||
         std::ranges::any_of(p.flow.own, [](const body::Motion& one) { return one.moves(); });
}

}  // namespace

Wake cancel_slip(Blobs& blobs, const WallPoints& found, const Problem& p, double time, double core,
                 bool impulsive) {
  const Blobs all = with_drifting(blobs, p);
  const FoldedBlobs at = fold(all, &p.wall->shape(), found);
  Wake wake;
  const bool stream = dot(p.flow.stream, p.flow.stream) > 0 && !p.flow.motion.moves();
  const flow::WakeLine line =
      stream && p.wall->rings().size() == 1
          ? flow::wake_line(p.wall->middles(), p.wall->shape(), p.flow.stream)
          : flow::WakeLine{};
  const AtRest at_rest = with_sheet(line.points(), all, at, p, time, impulsive);
  wake.sheet = impulsive ? at_rest.sheet : as_released(at_rest, p, core);
  const Blobs fresh = released(wake.sheet, *p.wall, core);
  wake.bubble_length = flow::bubble_length(line, at_rest.u.u, at_rest.u.v);
  const Vec2 of_sheet =
      impulsive ? p.wall->first_moment(wake.sheet) : invariants(fresh, &p.wall->shape()).moment;
  wake.moment = invariants(blobs, at).moment + of_sheet + p.outflow.moment;
  WallShear shear = wall_shear(blobs, wake.sheet, *p.wall, p.flow.nu, p.dt, p.sigma_0, found);
  wake.wall_vorticity = std::move(shear.vorticity);
  wake.friction = std::move(shear.friction);
  wake.pressure = pressure_loads(wake.sheet, *p.wall, p.dt);
  wake.pressure_slope.resize(p.wall->panels());
  add(wake.pressure_slope, -1 / p.dt, wake.sheet);
  if (own_motions(p))
    for (std::size_t k = 0; k < p.wall->rings().size(); ++k) add_own_motion(k, wake, p, time);
  if (p.flow.motion.turns()) wake.moment = Turn(p.flow.motion.at(time).angle)(wake.moment);
  append(blobs, fresh);
  return wake;
}

}  // namespace vortree::vortex
