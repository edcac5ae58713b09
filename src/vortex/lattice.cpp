#include "vortex/lattice.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace vortree::vortex {

Blobs gaussian_vortex(Vec2 centre, double gamma, double core, double sigma_0, double h) {
  if (!(core > sigma_0 && sigma_0 > 0 && h > 0))
    throw std::invalid_argument("a vortex of core " + std::to_string(core) + " cut into cores of " +
                                std::to_string(sigma_0) + " every " + std::to_string(h) +
                                "; core > sigma_0 > 0 and spacing > 0 were expected");
  const double s2 = core * core - sigma_0 * sigma_0;
  const double smallest = 1e-12;
  const int reach = static_cast<int>(std::sqrt(-s2 * std::log(smallest)) / h) + 1;
  Blobs blobs;
  double total = 0;
  for (int j = -reach; j <= reach; ++j)
    for (int i = -reach; i <= reach; ++i) {
      const double weight = std::exp(-(i * i + j * j) * h * h / s2);
      if (weight < smallest) continue;
      blobs.append(centre + Vec2{i * h, j * h}, weight, sigma_0);
      total += weight;
    }
  for (double& g : blobs.gamma) g *= gamma / total;
  return blobs;
}

}  // namespace vortree::vortex
