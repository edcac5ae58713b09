#include "vortex/spread_cores.hpp"

#include <cmath>

namespace vortree::vortex {

void spread_cores(Blobs& blobs, double nu, double dt) {
  for (double& sigma : blobs.sigma) sigma = std::sqrt(sigma * sigma + 4 * nu * dt);
}

}  // namespace vortree::vortex
