#include "sph/operators/interpolate.hpp"

#include "tree/neighbors/neighbors.hpp"

namespace vortree::sph {
namespace {

constexpr double radius = 1.5;  // in spacings

/// Vorticity at a particle and how it changes from there, to first order.
double vorticity_at(const Slopes& of, Vec2 by) {
  const FieldSlopes &u = of[0], &v = of[1];
  return vorticity(of) + (v.xx - u.xy) * by.x + (v.xy - u.yy) * by.y;
}

}  // namespace

Interpolated interpolate(const Cloud& cloud, const std::vector<Slopes>& slopes,
                         std::span<const std::uint32_t> chosen, tree::Points at) {
  const std::size_t n = chosen.size(), m = at.size();
  std::vector<double> x(n), y(n), reach(n + m, 0);
  for (std::size_t k = 0; k < n; ++k) {
    x[k] = cloud.x[chosen[k]], y[k] = cloud.y[chosen[k]];
    reach[k] = 2 * radius * cloud.spacing[chosen[k]];  // the mean with 0 is half of it
  }
  x.insert(x.end(), at.x.begin(), at.x.end()), y.insert(y.end(), at.y.begin(), at.y.end());
  const tree::PairList rows = tree::neighbors({x, y}, reach, tree::PairRule::mean);
  Interpolated of{std::vector<double>(m), std::vector<double>(m), std::vector<double>(m),
                  std::vector<char>(m)};
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < m; ++k) {
    double sum = 0;
    for (const std::int32_t row : rows.row(n + k)) {
      if (static_cast<std::size_t>(row) >= n) continue;
      const std::size_t j = chosen[static_cast<std::size_t>(row)];
      const Vec2 by{at.x[k] - cloud.x[j], at.y[k] - cloud.y[j]};
      const double t = 1 - dot(by, by) / (radius * radius * cloud.volume(j)), w = t * t * t;
      sum += w;
      of.u[k] += w * (cloud.u[j] + slopes[j][0].change(by));
      of.v[k] += w * (cloud.v[j] + slopes[j][1].change(by));
      of.omega[k] += w * vorticity_at(slopes[j], by);
    }
    of.covered[k] = sum > 0;
    if (sum > 0) of.u[k] /= sum, of.v[k] /= sum, of.omega[k] /= sum;
  }
  return of;
}

}  // namespace vortree::sph
