#include "flow/initial/lattice.hpp"

#include <cmath>

namespace vortree::flow {

std::vector<LatticeCore> cut(const Patch& patch, double sigma, double h, double faintest) {
  const Vec2 reach = patch.extent(faintest, sigma, h);
  const int columns = static_cast<int>(reach.x / h) + 1, rows = static_cast<int>(reach.y / h) + 1;
  std::vector<LatticeCore> cores;
  double total = 0;
  for (int j = -rows; j <= rows; ++j)
    for (int i = -columns; i <= columns; ++i) {
      const Vec2 at{i * h, j * h};
      const double weight = patch.weight(at, sigma, h);
      if (std::abs(weight) < faintest) continue;
      cores.push_back({at, weight});
      total += weight;
    }
  for (LatticeCore& core : cores) core.gamma *= patch.circulation / total;
  return cores;
}

}  // namespace vortree::flow
