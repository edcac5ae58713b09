#include "sph/motion/periodic_flow.hpp"

#include <algorithm>
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

namespace {

/// Of what a flow was at its start: less of its velocity is noise, and squares of it underflow.
constexpr double faded = 1e-6;

double magnitude(Vec2 a) {
  return std::sqrt(dot(a, a));
}

double norm(const Cloud& cloud, const auto& of) {
  return std::sqrt(sum(cloud, [&](std::size_t i) { return std::pow(of(i), 2); }));
}

/// In those of the exact flow, or of what it was at its start if it has decayed to that share.
double relative(double off, double now, double at_start, double share) {
  const double to = std::max(now, share * at_start);
  return to > 0 ? off / to : off;
}

double velocity_error(const Cloud& cloud, const flow::PeriodicFlow& exact, double t) {
  const auto speed = [&](double when) {
    return norm(cloud, [&](std::size_t i) { return magnitude(exact.velocity(cloud.at(i), when)); });
  };
  const double off = norm(cloud, [&](std::size_t i) {
    return magnitude(cloud.velocity(i) - exact.velocity(cloud.at(i), t));
  });
  return relative(off, speed(t), speed(0), faded);
}

/// Of pressures without their means.
double pressure_error(const Cloud& cloud, const flow::PeriodicFlow& exact, double t) {
  const double volume = sum(cloud, [](std::size_t) { return 1.0; });
  const auto varying = [&](const auto& p) {
    const double mean = sum(cloud, p) / volume;
    return norm(cloud, [&](std::size_t i) { return p(i) - mean; });
  };
  const auto pressure = [&](double when) {
    return varying(
        [&exact, &cloud, when](std::size_t i) { return exact.pressure(cloud.at(i), when); });
  };
  const double off =
      varying([&](std::size_t i) { return cloud.p[i] - exact.pressure(cloud.at(i), t); });
  return relative(off, pressure(t), pressure(0), faded * faded);
}

}  // namespace

PeriodicBudget budget(const Cloud& cloud, const std::vector<Slopes>& slopes,
                      const flow::PeriodicFlow& exact, double t) {
  PeriodicBudget made;
  made.volume = sum(cloud, [](std::size_t) { return 1.0; });
  made.momentum = {sum(cloud, [&](std::size_t i) { return cloud.u[i]; }),
                   sum(cloud, [&](std::size_t i) { return cloud.v[i]; })};
  made.energy =
      sum(cloud, [&](std::size_t i) { return dot(cloud.velocity(i), cloud.velocity(i)) / 2; });
  made.enstrophy = sum(cloud, [&](std::size_t i) { return std::pow(vorticity(slopes[i]), 2); });
  made.velocity_error = velocity_error(cloud, exact, t);
  made.pressure_error = pressure_error(cloud, exact, t);
  return made;
}

}  // namespace vortree::sph
