#include "sph/motion/edge_filter.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "sph/pairs/kernel_shapes.hpp"

namespace vortree::sph {
namespace {

using Carried = std::array<double, carried_count>;

double distance(Vec2 d) {
  return std::sqrt(dot(d, d));
}

/// The series that is taken off. Pair sums hand half their Laplacian to each second derivative,
/// which would take off the most of what alternates.
FieldSlopes series(FieldSlopes of, const OperatorOptions& options) {
  if (options.kind == OperatorKind::pair_sums) of.xx = of.xy = of.yy = 0;
  return of;
}

/// By how much the neighbors differ from the series through the particle, in the mean.
Carried excess(const Cloud& cloud, const Stencils& stencils, const Slopes& of,
               const OperatorOptions& options, std::size_t i) {
  std::array<FieldSlopes, carried_count> taken{};
  for (std::size_t field = 0; field < carried_count; ++field)
    taken[field] = series(of[field], options);
  Carried sum{};
  double weights = 0;
  stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
    const Vec2 d = stencils.offset(slot);
    const double reach = 0.5 * fitted_reach(options) * (cloud.spacing[i] + cloud.spacing[j]);
    const double w = WendlandC4<2>::shape(2 * distance(d) / reach) * cloud.volume(j);
    weights += w;
    for (std::size_t field = 0; field < carried_count; ++field) {
      const std::vector<double>& f = cloud.*carried[field];
      sum[field] += w * (f[j] - f[i] - taken[field].change(d));
    }
  });
  for (double& value : sum) value = weights > 0 ? value / weights : 0;
  return sum;
}

/// A node of the outer boundary is so near that fits are of degree 2: what alternates, higher
/// degrees see whole, and a series taken off makes it grow.
bool chosen(const Cloud& cloud, const Stencils& stencils, const OperatorOptions& options,
            std::size_t i) {
  const double near = fitted_reach(options) * cloud.spacing[i];
  bool found = options.degree == 2;
  stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
    found = found || (!cloud.inside(j) && distance(stencils.offset(slot)) <= near);
  });
  return found;
}

}  // namespace

void filter_edges(Cloud& cloud, const Stencils& stencils, const std::vector<Slopes>& slopes,
                  const OperatorOptions& options, double share) {
  std::vector<std::pair<std::size_t, Carried>> changes;
  const std::vector<char> beside = stencils.beside_edge(cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud.free(i) && beside[i] && chosen(cloud, stencils, options, i))
      changes.push_back({i, {}});
#pragma omp parallel for schedule(static)
  for (auto& [i, by] : changes) by = excess(cloud, stencils, slopes[i], options, i);
  for (const auto& [i, by] : changes)
    for (std::size_t field = 0; field + 1 < carried_count; ++field)
      (cloud.*carried[field])[i] += share * by[field];
}

}  // namespace vortree::sph
