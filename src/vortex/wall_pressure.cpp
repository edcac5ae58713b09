#include "vortex/wall_pressure.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "base/ordered_sum.hpp"

namespace vortree::vortex {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// The sheet of the flow that circles the body: its speed on the wall.
std::vector<double> circling(const Wall& wall) {
  return wall.sheet(std::vector<double>(wall.panels()), two_pi);
}

/// 1/(2 pi) oint w f ds.
double mean(const Wall& wall, std::span<const double> w, const auto& of_panel) {
  double sum = 0;
  for (std::size_t i = 0; i < wall.panels(); ++i) sum += w[i] * of_panel(i);
  return wall.panel_length() / two_pi * sum;
}

/// int omega u.V dA.
double weighted_vorticity(const Blobs& blobs, const Problem& p, std::span<const double> w) {
  const MovingBlobs all = moving(blobs, p);
  Velocities circle(all.blobs.size());
  p.wall->add_velocity(w, p.sums, {all.at.x, all.at.y}, circle, all.at.wall);
  return ordered_sum(all.blobs.size(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t j = first; j < last; ++j)
      sum += all.blobs.gamma[j] * (all.u.u[j] * circle.u[j] + all.u.v[j] * circle.v[j]);
    return sum;
  });
}

double level(const Blobs& blobs, const Problem& p, std::span<const double> w) {
  const Vec2 stream = p.flow.stream_at(p.time);
  const double rate = p.turning ? p.flow.motion.at(p.time).rate : 0;
  const double of_wall = mean(*p.wall, w, [&](std::size_t i) {
    return rate * rate / 2 * dot(p.wall->middle(i), p.wall->middle(i));
  });
  return dot(stream, stream) / 2 - of_wall - weighted_vorticity(blobs, p, w) / two_pi;
}

}  // namespace

std::vector<double> integrated(const Wall& wall, std::span<const double> slope) {
  const double b = wall.panel_length();
  const double open =
      std::accumulate(slope.begin(), slope.end(), 0.0) / static_cast<double>(slope.size());
  std::vector<double> p;
  double edge = 0;
  for (const double rise : slope) {
    p.push_back(edge + b / 2 * (rise - open));
    edge += b * (rise - open);
  }
  return p;
}

double pressure_level(const Blobs& blobs, const Problem& problem) {
  return level(blobs, problem, circling(*problem.wall));
}

std::vector<double> wall_pressure(const Blobs& blobs, const Problem& problem,
                                  std::span<const double> slope) {
  const Wall& wall = *problem.wall;
  std::vector<double> p = integrated(wall, slope);
  const body::Kinematics between = problem.flow.motion.at(problem.time - problem.dt / 2);
  const Vec2 driven = Turn(-between.angle)(between.acceleration);
  for (std::size_t i = 0; i < p.size(); ++i) p[i] -= dot(driven, wall.middle(i));
  const std::vector<double> w = circling(wall);
  const double raise =
      level(blobs, problem, w) - mean(wall, w, [&](std::size_t i) { return p[i]; });
  for (double& one : p) one += raise;
  return p;
}

}  // namespace vortree::vortex
