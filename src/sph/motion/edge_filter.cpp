#include "sph/motion/edge_filter.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "sph/pairs/kernel_shapes.hpp"

namespace vortree::sph {
namespace {

using Carried = std::array<double, carried_count>;

/// By how much the neighbors differ from the series through the particle, in the mean.
Carried excess(const Cloud& cloud, const Stencils& stencils, const Slopes& of,
               const OperatorOptions& options, std::size_t i) {
  Carried sum{};
  double weights = 0;
  stencils.for_each(i, [&](std::size_t j, std::size_t slot) {
    const Vec2 d = stencils.offset(slot);
    const double reach = 0.5 * options.reach * (cloud.spacing[i] + cloud.spacing[j]);
    const double w = WendlandC4<2>::shape(2 * std::sqrt(dot(d, d)) / reach) * cloud.volume(j);
    weights += w;
    for (std::size_t field = 0; field < carried_count; ++field) {
      const std::vector<double>& f = cloud.*carried[field];
      sum[field] += w * (f[j] - f[i] - of[field].change(d));
    }
  });
  for (double& value : sum) value = weights > 0 ? value / weights : 0;
  return sum;
}

}  // namespace

void filter_edges(Cloud& cloud, const Stencils& stencils, const std::vector<Slopes>& slopes,
                  const OperatorOptions& options, double share) {
  std::vector<std::pair<std::size_t, Carried>> chosen;
  const std::vector<char> beside = stencils.beside_edge(cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud.free(i) && beside[i]) chosen.push_back({i, {}});
#pragma omp parallel for schedule(static)
  for (auto& [i, by] : chosen) by = excess(cloud, stencils, slopes[i], options, i);
  for (const auto& [i, by] : chosen)
    for (std::size_t field = 0; field + 1 < carried_count; ++field)
      (cloud.*carried[field])[i] += share * by[field];
}

}  // namespace vortree::sph
