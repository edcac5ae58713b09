#pragma once

#include <vector>

#include "flow/initial/initial_flow.hpp"

namespace vortree::flow {

/// A core that a patch is cut into, as seen from the patch's centre [L], and its circulation.
struct LatticeCore {
  Vec2 at;
  double gamma = 0;
};

/// Cores of width sigma on a lattice of step h, row by row, that are the patch together; those
/// below `faintest` of the strongest are left out, and the others have all of its circulation.
/// error   that of Patch::weight
/// cost    O(places of the lattice)
[[nodiscard]] std::vector<LatticeCore> cut(const Patch& patch, double sigma, double h,
                                           double faintest);

}  // namespace vortree::flow
