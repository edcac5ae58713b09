#include "vortex/wall_pressure.hpp"

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

/// int omega u.V dA.
double weighted_vorticity(const MovingBlobs& all, const Problem& p, std::span<const double> w) {
  Velocities circle(all.blobs.size());
  p.wall->add_velocity(w, p.sums, {all.at.x, all.at.y}, circle, all.at.wall);
  return ordered_sum(all.blobs.size(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t j = first; j < last; ++j)
      sum += all.blobs.gamma[j] * (all.u.u[j] * circle.u[j] + all.u.v[j] * circle.v[j]);
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

std::vector<double> integrated(const Wall& wall, std::span<const double> slope) {
  std::vector<double> p(wall.panels());
  const std::span<const double> lengths = wall.panel_lengths();
  for (const Ring& ring : wall.rings())
    integrate(ring.of(slope), ring.of(lengths), ring.length, ring.of(p));
  return p;
}

double pressure_level(const Blobs& blobs, const Problem& problem) {
  return level(moving(blobs, problem), problem, circling(*problem.wall, 0));
}

std::vector<double> wall_pressure(const Blobs& blobs, const Problem& problem,
                                  std::span<const double> slope) {
  const Wall& wall = *problem.wall;
  std::vector<double> p = integrated(wall, slope);
  const body::Kinematics between = problem.flow.motion.at(problem.time - problem.dt / 2);
  const Vec2 driven = Turn(-between.angle)(between.acceleration);
  for (std::size_t i = 0; i < p.size(); ++i) p[i] -= dot(driven, wall.middle(i));
  const MovingBlobs all = moving(blobs, problem);
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
