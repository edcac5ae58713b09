#include "sph/motion/periodic_flow.hpp"

#include <cmath>

namespace vortree::sph {
namespace {

/// Sums over all particles of their volume times something.
double sum(const Cloud& cloud, const auto& of) {
  double all = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) all += cloud.volume(i) * of(i);
  return all;
}

}  // namespace

void begin(Cloud& cloud, const flow::PeriodicFlow& exact) {
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec2 u = exact.velocity(cloud.at(i), 0);
    cloud.u[i] = cloud.u_before[i] = u.x, cloud.v[i] = cloud.v_before[i] = u.y;
    cloud.p[i] = exact.pressure(cloud.at(i), 0);
  }
}

PeriodicBudget budget(const Cloud& cloud, const std::vector<Slopes>& slopes,
                      const flow::PeriodicFlow& exact, double t) {
  const auto u = [&](std::size_t i) { return exact.velocity(cloud.at(i), t); };
  const auto p = [&](std::size_t i) { return exact.pressure(cloud.at(i), t); };
  PeriodicBudget made;
  made.volume = sum(cloud, [](std::size_t) { return 1.0; });
  made.momentum = {sum(cloud, [&](std::size_t i) { return cloud.u[i]; }),
                   sum(cloud, [&](std::size_t i) { return cloud.v[i]; })};
  made.energy =
      sum(cloud, [&](std::size_t i) { return dot(cloud.velocity(i), cloud.velocity(i)) / 2; });
  made.enstrophy = sum(cloud, [&](std::size_t i) { return std::pow(vorticity(slopes[i]), 2); });
  const auto off = [&](std::size_t i) {
    const Vec2 d = cloud.velocity(i) - u(i);
    return dot(d, d);
  };
  made.velocity_error =
      std::sqrt(sum(cloud, off) / sum(cloud, [&](std::size_t i) { return dot(u(i), u(i)); }));
  const double mean = sum(cloud, p) / made.volume,
               difference =
                   sum(cloud, [&](std::size_t i) { return cloud.p[i]; }) / made.volume - mean;
  made.pressure_error = std::sqrt(
      sum(cloud, [&](std::size_t i) { return std::pow(cloud.p[i] - p(i) - difference, 2); }) /
      sum(cloud, [&](std::size_t i) { return std::pow(p(i) - mean, 2); }));
  return made;
}

}  // namespace vortree::sph
