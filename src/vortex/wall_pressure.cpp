#include "vortex/wall_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/ordered_sum.hpp"

namespace vortree::vortex {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// The sheet of the flow that circles a body, and no other: its speed on the wall.
std::vector<double> circling(const Wall& wall, std::size_t body) {
  std::vector<double> totals(wall.rings().size());
  totals[body] = two_pi;
  return wall.sheet(std::vector<double>(wall.panels()), totals);
}

/// 1/(2 pi) oint w f ds around all bodies.
double mean(const Wall& wall, std::span<const double> w, const auto& of_panel) {
  double sum = 0;
  for (const Ring& ring : wall.rings()) {
    double around = 0;
    for (std::size_t i = ring.first; i < ring.end(); ++i)
      around += wall.panel_length(i) / ring.length * w[i] * of_panel(i);
    sum += ring.length / two_pi * around;
  }
  return sum;
}

/// What a sheet does to blobs: its velocity V where they act, and how that changes there. V has
/// neither curl nor divergence, so that its change along one direction tells all.
class SheetAtBlobs {
 public:
  SheetAtBlobs(std::span<const double> sheet, const MovingBlobs& all, const Problem& p)
      : here_(all.blobs.size()), aside_(all.blobs.size()) {
    std::vector<double> x = all.at.x, y = all.at.y;
    for (std::size_t j = 0; j < x.size(); ++j) {
      const body::WallPoint wall = all.at.wall.known(j);
      const double way = std::max(all.at.sigma[j], panels_aside * p.wall->panel_length(0));
      way_.push_back(way * (wall.distance < INFINITY ? wall.normal : Vec2{1, 0}));
      x[j] += way_[j].x, y[j] += way_[j].y;
    }
    p.wall->add_velocity(sheet, p.sums, {all.at.x, all.at.y}, here_, all.at.wall);
    p.wall->add_velocity(sheet, p.sums, {x, y}, aside_);
  }

  Vec2 velocity(std::size_t j) const { return {here_.u[j], here_.v[j]}; }
  Gradient gradient(std::size_t j) const {
    const Vec2 d = way_[j], dV{aside_.u[j] - here_.u[j], aside_.v[j] - here_.v[j]};
    const double xx = (d.x * dV.x - d.y * dV.y) / dot(d, d),
                 xy = (d.y * dV.x + d.x * dV.y) / dot(d, d);
    return {xx, xy, xy};
  }

 private:
  static constexpr double panels_aside = 2;  // nearer a sheet in panels is rough

  Velocities here_, aside_;
  std::vector<Vec2> way_;
};

/// What the mean of u.V over a core has beyond the product of their means: the sum of
/// C_km d_k u_l d_m V_l, C the core's covariance.
double spread(const Core& core, const Gradient& u, const Gradient& V) {
  const double half = core.square / 2, xx = half + core.deviator.xx, xy = core.deviator.xy,
               yy = half - core.deviator.xx;
  return u.ux * (xx * V.ux + xy * V.uy) + u.uy * (xy * V.ux + yy * V.uy) +
         u.vx * (xx * V.vx - xy * V.ux) - u.ux * (xy * V.vx - yy * V.ux);
}

/// int omega u.V dA.
double weighted_vorticity(const MovingBlobs& all, const Problem& p, std::span<const double> w) {
  const SheetAtBlobs circle(w, all, p);
  return ordered_sum(all.blobs.size(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t j = first; j < last; ++j) {
      const Gradient slope{all.slope.ux[j], all.slope.uy[j], all.slope.vx[j]};
      sum += all.blobs.gamma[j] * (dot({all.u.u[j], all.u.v[j]}, circle.velocity(j)) +
                                   spread(all.at.folded(j).core, slope, circle.gradient(j)));
    }
    return sum;
  });
}

/// |u|^2/2 of the wall at each panel.
std::vector<double> energy_of_wall(const Problem& p) {
  std::vector<double> energy;
  for (std::size_t k = 0; k < p.wall->rings().size(); ++k) {
    const Ring& ring = p.wall->rings()[k];
    const Vec2 of_centre = p.flow.own_at(k, p.time).velocity;
    const double rate = p.flow.rate(k, p.time);
    for (std::size_t i = ring.first; i < ring.end(); ++i) {
      const Vec2 u = of_centre + rate * left_of(p.wall->middle(i) - ring.centre);
      energy.push_back(dot(u, u) / 2);
    }
  }
  return energy;
}

double level(const MovingBlobs& all, const Problem& p, std::span<const double> w) {
  const Vec2 stream = p.flow.stream_at(p.time);
  const std::vector<double> energy = energy_of_wall(p);
  const double of_wall = mean(*p.wall, w, [&](std::size_t i) { return energy[i]; });
  return dot(stream, stream) / 2 - of_wall - weighted_vorticity(all, p, w) / two_pi;
}

/// What the means of a rate over the last step and the one before weigh in the rate at the end: by
/// the parabola, or from the last alone the line, in sqrt(t) or in t.
struct EndOfParabola {
  double last, before, of_line;

  EndOfParabola(double time, double dt, bool in_root) {
    const auto s = [&](double t) { return in_root ? std::sqrt(std::max(t, 0.0)) : t; };
    const double s0 = s(time - 2 * dt), s1 = s(time - dt), s2 = s(time);
    const double unit = dt / (in_root ? 2 * s2 : 1), share = (s2 - s1) / (s2 - s0);
    of_line = unit / (s2 - s1);
    last = (1 + share) * of_line;
    before = share * unit / (s1 - s0);
  }
};

/// The integral of a slope around a body in panels of lengths b, from anywhere on; what would not
/// close is spread evenly.
void integrate(std::span<const double> slope, std::span<const double> b, double mean,
               std::span<double> p) {
  double open = 0;
  for (std::size_t i = 0; i < slope.size(); ++i) open += b[i] / mean * slope[i];
  open /= static_cast<double>(slope.size());
  double edge = 0;
  for (std::size_t i = 0; i < slope.size(); ++i) {
    p[i] = edge + b[i] / 2 * (slope[i] - open);
    edge += b[i] * (slope[i] - open);
  }
}

}  // namespace

std::vector<double> slope_at_end(const SlopeMeans& known, double time, double dt, bool impulsive) {
  const EndOfParabola end(time, dt, impulsive);
  std::vector<double> slope;
  for (std::size_t i = 0; i < known.last.size(); ++i)
    slope.push_back(known.before.empty() ? end.of_line * known.last[i]
                                         : end.last * known.last[i] - end.before * known.before[i]);
  return slope;
}

std::vector<double> integrated(const Wall& wall, std::span<const double> slope) {
  std::vector<double> p(wall.panels());
  const std::span<const double> lengths = wall.panel_lengths();
  for (const Ring& ring : wall.rings())
    integrate(ring.of(slope), ring.of(lengths), ring.length, ring.of(p));
  return p;
}

double pressure_level(const Blobs& blobs, const Problem& problem) {
  return level(moving(blobs, problem, WithSlope::yes), problem, circling(*problem.wall, 0));
}

std::vector<double> wall_pressure(const Blobs& blobs, const Problem& problem,
                                  std::span<const double> slope) {
  const Wall& wall = *problem.wall;
  std::vector<double> p = integrated(wall, slope);
  const body::Kinematics frame = problem.flow.motion.at(problem.time);
  const Vec2 driven = Turn(-frame.angle)(frame.acceleration);
  for (std::size_t i = 0; i < p.size(); ++i) p[i] -= dot(driven, wall.middle(i));
  const MovingBlobs all = moving(blobs, problem, WithSlope::yes);
  std::vector<double> raises;
  for (std::size_t k = 0; k < wall.rings().size(); ++k) {
    const std::vector<double> w = circling(wall, k);
    raises.push_back(level(all, problem, w) - mean(wall, w, [&](std::size_t i) { return p[i]; }));
  }
  for (std::size_t k = 0; k < raises.size(); ++k)
    for (double& one : wall.rings()[k].of(p)) one += raises[k];
  return p;
}

}  // namespace vortree::vortex
