#include "sph/motion/shift.hpp"

#include <algorithm>
#include <cmath>

#include "sph/motion/tuning.hpp"
#include "sph/operators/gather_kernel.hpp"

namespace vortree::sph {
namespace {

double magnitude(Vec2 a) {
  return std::sqrt(dot(a, a));
}

/// a repulsion, but no further than `most`.
Vec2 bounded(double a, Vec2 repulsion, double most) {
  const double length = a * magnitude(repulsion);
  return (length > most ? a * most / length : a) * repulsion;
}

/// |grad u| + 0.05 |u|/s: how fast the flow brings particles into disorder.
double disorder(const Cloud& cloud, const Slopes& of, std::size_t i) {
  const auto& [u, v, u_before, v_before, p] = of;
  const double strain = std::sqrt(u.x * u.x + u.y * u.y + v.x * v.x + v.y * v.y);
  return strain + 0.05 * magnitude(cloud.velocity(i)) / cloud.spacing[i];
}

/// Where the fluid of a particle that stands still comes from, as seen from it.
Vec2 origin(const Cloud& cloud, const Slopes& of, std::size_t i, const TimeStep& step) {
  Vec2 from{};
  for (int again = 0; again < 2; ++again) {
    const auto [u, v, u_before, v_before, p] = carried_at(cloud, i, of, from);
    from = -step.dt * Vec2{step.middle(u, u_before), step.middle(v, v_before)};
  }
  return from;
}

}  // namespace

std::vector<Vec2> repulsions(const Cloud& cloud, const Stencils& stencils) {
  const std::size_t n = cloud.size();
  std::vector<Vec2> of(n);
#pragma omp parallel for schedule(static)
  for (std::size_t group = 0; group < stencils.groups(); ++group) {
    const std::size_t from = group * lane_count;
    const Lanes spacing = own(cloud.spacing, from);
    Lanes x{}, y{};
    for (std::size_t k = stencils.first(group); k < stencils.first(group + 1); ++k) {
      const auto [dx, dy] = stencils.offsets(k);
      const Lanes other = gather(cloud.spacing, stencils.indices() + k * lane_count);
      const Lanes r = root(dx * dx + dy * dy);
      const Lanes t = larger(1.0 - r / (0.75 * (spacing + other)), Lanes{});
      const Lanes push = r > Lanes{} ? t * t / r : Lanes{};
      x -= push * dx, y -= push * dy;
    }
    for (int lane = 0; lane < lane_count && from + lane < n; ++lane)
      of[from + lane] = {x[lane], y[lane]};
  }
  return of;
}

void shift_and_move(Cloud& cloud, const Stencils& stencils, const std::vector<Slopes>& slopes,
                    const TimeStep& step, double strength) {
  const std::size_t n = cloud.size();
  std::vector<Vec2> by(n);
  const std::vector<Vec2> repulsion = repulsions(cloud, stencils);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    const double s = cloud.spacing[i];
    if (cloud.passed(i)) by[i] = origin(cloud, slopes[i], i, step);
    if (!cloud.free(i)) continue;
    const double a = std::min(most_shift, strength * step.dt * disorder(cloud, slopes[i], i)) * s;
    by[i] = bounded(a, repulsion[i], longest_shift * s);
  }
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    if (!cloud.free(i) && !cloud.passed(i)) continue;
    const auto values = carried_at(cloud, i, slopes[i], by[i]);
    for (std::size_t field = 0; field < carried_count; ++field)
      (cloud.*carried[field])[i] = values[field];
    if (!cloud.free(i)) continue;
    const auto [u, v, u_before, v_before, p] = values;
    cloud.x[i] += by[i].x + step.dt * step.middle(u, u_before);
    cloud.y[i] += by[i].y + step.dt * step.middle(v, v_before);
  }
}

void spread_evenly(Cloud& cloud, const Stencils& stencils) {
  const std::vector<Vec2> repulsion = repulsions(cloud, stencils);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.free(i)) continue;
    const Vec2 by = bounded(0.2 * cloud.spacing[i], repulsion[i], 0.1 * cloud.spacing[i]);
    cloud.x[i] += by.x, cloud.y[i] += by.y;
  }
}

}  // namespace vortree::sph
