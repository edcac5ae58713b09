#pragma once

#include <optional>
#include <vector>

#include "sph/adapt/population.hpp"
#include "sph/adapt/wanted_spacing.hpp"
#include "sph/boundary/outer_box.hpp"

namespace vortree::sph {

/// How fine particles are to be where vorticity is strong,
///
///   s = change/omega,   omega the root mean square of a particle's vorticity and its neighbors',
///
/// so that velocity changes by no more than `change` from one side of a particle to the other; at
/// least `finest`. Around it they widen by a quarter of the distance, as they do from the coarsest
/// nodes of the box inwards:
///
///   s_i <= s_j + |x_j - x_i|/4,   s_i >= coarsest - depth_i/4,   depth to the box
///
/// change   [L/T]
struct VorticityWish {
  double change = 0, finest = 0;
  OuterBox box{};
};

/// The spacing that is wanted of each old particle that is free: the least of what its place asks
/// for and its vorticity, if that counts. Of others 0.
///
/// cost     O(n), and a few passes over all neighbors if vorticity counts
[[nodiscard]] std::vector<double> wishes(const Population& population, const WantedSpacing& wanted,
                                         const std::optional<VorticityWish>& by_vorticity = {});

}  // namespace vortree::sph
