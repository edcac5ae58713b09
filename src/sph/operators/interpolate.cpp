#include "sph/operators/interpolate.hpp"

#include <algorithm>

#include "sph/neighbors/periodic_images.hpp"
#include "tree/neighbors/neighbors.hpp"

namespace vortree::sph {
namespace {

constexpr double radius = 1.5;  // in spacings
constexpr std::size_t of_pressure = 4;
static_assert(carried[of_pressure] == &Cloud::p);

/// Vorticity at a particle and how it changes from there, to first order.
double vorticity_at(const Slopes& of, Vec2 by) {
  const FieldSlopes &u = of[0], &v = of[1];
  return vorticity(of) + (v.xx - u.xy) * by.x + (v.xy - u.yy) * by.y;
}

}  // namespace

double share_of_series(Vec2 by, double volume) {
  const double t = std::max(1 - dot(by, by) / (radius * radius * volume), 0.0);
  return t * t * t;
}

Interpolated interpolate(const Cloud& cloud, const std::vector<Slopes>& slopes,
                         std::span<const std::uint32_t> chosen, tree::Points at, double period) {
  const std::size_t m = at.size();
  std::vector<double> x, y, reach;
  for (const std::uint32_t i : chosen) {
    x.push_back(cloud.x[i]), y.push_back(cloud.y[i]);
    reach.push_back(2 * radius * cloud.spacing[i]);  // the mean with 0 is half of it
  }
  PeriodicImages all;
  all.renew({x, y}, reach, std::vector<std::int32_t>(chosen.size(), -1), period);
  const std::size_t n = all.of.size();
  all.x.insert(all.x.end(), at.x.begin(), at.x.end());
  all.y.insert(all.y.end(), at.y.begin(), at.y.end());
  all.reach.resize(n + m, 0);
  const tree::PairList rows = tree::neighbors({all.x, all.y}, all.reach, tree::PairRule::mean);
  const std::vector<double> none(m);
  Interpolated of{none, none, none, none, std::vector<char>(m)};
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < m; ++k) {
    double sum = 0;
    for (const std::int32_t row : rows.row(n + k)) {
      if (static_cast<std::size_t>(row) >= n) continue;
      const std::size_t j = chosen[static_cast<std::size_t>(all.of[row])];
      const Vec2 by{at.x[k] - all.x[row], at.y[k] - all.y[row]};
      const double w = share_of_series(by, cloud.volume(j));
      sum += w;
      of.u[k] += w * (cloud.u[j] + slopes[j][0].change(by));
      of.v[k] += w * (cloud.v[j] + slopes[j][1].change(by));
      of.omega[k] += w * vorticity_at(slopes[j], by);
      of.p[k] += w * (cloud.p[j] + slopes[j][of_pressure].change(by));
    }
    of.covered[k] = sum > 0;
    if (sum > 0) of.u[k] /= sum, of.v[k] /= sum, of.omega[k] /= sum, of.p[k] /= sum;
  }
  return of;
}

}  // namespace vortree::sph
