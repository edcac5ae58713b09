#include "sph/motion/initial_vortices.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "flow/initial/lattice.hpp"
#include "fmm/plan.hpp"

namespace vortree::sph {
namespace {

constexpr double width_of_core = 1.0 / 6, faintest = 1e-9;  // of half widths; of the strongest

struct InitialCores {
  std::vector<double> x, y, gamma, sigma;
};

/// A patch as cores that are as wide as they are apart.
void add(InitialCores& cores, const flow::Patch& patch, Vec2 middle) {
  const double h = width_of_core * std::min(patch.half.x, patch.half.y);
  for (const auto& [at, gamma] : flow::cut(patch, h, h, faintest)) {
    cores.x.push_back(middle.x + at.x), cores.y.push_back(middle.y + at.y);
    cores.gamma.push_back(gamma), cores.sigma.push_back(h);
  }
}

}  // namespace

double add_initial_vortices(Cloud& cloud, const flow::InitialSettings& initial, Vec2 seen_from) {
  const Vec2 centre = Vec2{initial.centre[0], initial.centre[1]} - seen_from;
  InitialCores cores;
  for (const flow::Patch& patch : initial.kind->patches(initial))
    add(cores, patch, centre + patch.offset);
  const fmm::Plan plan({cores.x, cores.y, cores.gamma, cores.sigma}, {.tolerance = 1e-6});
  std::vector<double> u(cloud.size()), v(cloud.size());
  plan.velocity({cloud.x, cloud.y, {}}, u, v);
  for (std::size_t i = 0; i < cloud.size(); ++i) cloud.u[i] += u[i], cloud.v[i] += v[i];
  return std::accumulate(cores.gamma.begin(), cores.gamma.end(), 0.0);
}

}  // namespace vortree::sph
