#include "sph/motion/initial_vortices.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "fmm/plan.hpp"

namespace vortree::sph {
namespace {

constexpr double width_of_core = 1.0 / 6, faintest = 1e-9;  // of half widths; of the strongest

struct InitialCores {
  std::vector<double> x, y, gamma, sigma;
};

/// Cuts a patch into cores as wide as they are apart.
void cut(InitialCores& cores, const flow::Patch& patch, Vec2 middle) {
  const double h = width_of_core * std::min(patch.half.x, patch.half.y);
  const Vec2 reach = patch.extent(faintest, h, h);
  const int columns = static_cast<int>(reach.x / h) + 1, rows = static_cast<int>(reach.y / h) + 1;
  const std::size_t before = cores.gamma.size();
  double total = 0;
  for (int j = -rows; j <= rows; ++j)
    for (int i = -columns; i <= columns; ++i) {
      const double weight = patch.weight({i * h, j * h}, h, h);
      cores.x.push_back(middle.x + i * h), cores.y.push_back(middle.y + j * h);
      cores.gamma.push_back(weight), cores.sigma.push_back(h);
      total += weight;
    }
  for (std::size_t k = before; k < cores.gamma.size(); ++k)
    cores.gamma[k] *= patch.circulation / total;
}

}  // namespace

double add_initial_vortices(Cloud& cloud, const flow::InitialSettings& initial, Vec2 seen_from) {
  const Vec2 centre = Vec2{initial.centre[0], initial.centre[1]} - seen_from;
  InitialCores cores;
  for (const flow::Patch& patch : initial.kind->patches(initial))
    cut(cores, patch, centre + patch.offset);
  const fmm::Plan plan({cores.x, cores.y, cores.gamma, cores.sigma}, {.tolerance = 1e-6});
  std::vector<double> u(cloud.size()), v(cloud.size());
  plan.velocity({cloud.x, cloud.y, {}}, u, v);
  for (std::size_t i = 0; i < cloud.size(); ++i) cloud.u[i] += u[i], cloud.v[i] += v[i];
  return std::accumulate(cores.gamma.begin(), cores.gamma.end(), 0.0);
}

}  // namespace vortree::sph
