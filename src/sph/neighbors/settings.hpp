#pragma once

#include <vector>

#include "base/keys.hpp"
#include "neighbors/methods.hpp"

// The table [neighbors] of a scene by SPH.

namespace vortree::sph {

/// How the neighbors of all particles are found in every step. Which ones they are does not depend
/// on it, and with sorted rows no bit of the flow does.
///
/// method   of the search
/// sorted   neighbors of a particle stand in the order of their numbers
/// skin     lists are kept while particles have not used up such a margin
///          (sph/neighbors/kept_list.hpp), in spacings, and are sorted; 0: made anew in every step
struct NeighborSettings {
  neighbors::SearchMethod method = neighbors::SearchMethod::qcg;
  bool sorted = true;
  double skin = 0;
  bool operator==(const NeighborSettings&) const = default;
};

[[nodiscard]] std::vector<Key> keys(NeighborSettings&);

}  // namespace vortree::sph
