#include "sph/operators/derivatives.hpp"

#include "sph/operators/gather_kernel.hpp"

namespace vortree::sph {
namespace {

void put(std::span<double> to, std::size_t from, Lanes a) {
  for (int lane = 0; lane < lane_count && from + lane < to.size(); ++lane)
    to[from + lane] = a[lane];
}

}  // namespace

void find_slopes(const Cloud& cloud, const Stencils& stencils, std::vector<Slopes>& slopes) {
  const std::size_t n = cloud.size();
  slopes.resize(n);
#pragma omp parallel for schedule(static)
  for (std::size_t group = 0; group < stencils.groups(); ++group) {
    const std::size_t from = group * lane_count;
    for (std::size_t field = 0; field < carried_count; ++field) {
      const std::vector<double>& f = cloud.*carried[field];
      const Lanes here = own(f, from);
      std::array<Lanes, 5> sum{};
      for (std::size_t k = stencils.first(group); k < stencils.first(group + 1); ++k) {
        const Lanes change = gather(f, stencils.indices() + k * lane_count) - here;
        for (int e = 0; e < 5; ++e) sum[e] += load(stencils.weights(e) + k * lane_count) * change;
      }
      for (int lane = 0; lane < lane_count && from + lane < n; ++lane)
        slopes[from + lane][field] = {sum[0][lane], sum[1][lane], sum[2][lane], sum[3][lane],
                                      sum[4][lane]};
    }
  }
}

void find_divergence(std::span<const double> u, std::span<const double> v, const Stencils& stencils,
                     std::span<double> divergence) {
#pragma omp parallel for schedule(static)
  for (std::size_t group = 0; group < stencils.groups(); ++group) {
    const std::size_t from = group * lane_count;
    const Lanes u_here = own(u, from), v_here = own(v, from);
    Lanes sum{};
    for (std::size_t k = stencils.first(group); k < stencils.first(group + 1); ++k) {
      const std::int32_t* index = stencils.indices() + k * lane_count;
      sum += load(stencils.weights(0) + k * lane_count) * (gather(u, index) - u_here);
      sum += load(stencils.weights(1) + k * lane_count) * (gather(v, index) - v_here);
    }
    put(divergence, from, sum);
  }
}

void find_gradient(std::span<const double> f, const Stencils& stencils, std::span<double> fx,
                   std::span<double> fy) {
#pragma omp parallel for schedule(static)
  for (std::size_t group = 0; group < stencils.groups(); ++group) {
    const std::size_t from = group * lane_count;
    const Lanes here = own(f, from);
    Lanes x{}, y{};
    for (std::size_t k = stencils.first(group); k < stencils.first(group + 1); ++k) {
      const Lanes change = gather(f, stencils.indices() + k * lane_count) - here;
      x += load(stencils.weights(0) + k * lane_count) * change;
      y += load(stencils.weights(1) + k * lane_count) * change;
    }
    put(fx, from, x), put(fy, from, y);
  }
}

std::array<double, carried_count> carried_at(const Cloud& cloud, std::size_t i,
                                             const Slopes& slopes, Vec2 by) {
  std::array<double, carried_count> values;
  for (std::size_t field = 0; field < carried_count; ++field)
    values[field] = (cloud.*carried[field])[i] + slopes[field].change(by);
  return values;
}

}  // namespace vortree::sph
