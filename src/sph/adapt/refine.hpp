#pragma once

#include <vector>

#include "sph/adapt/population.hpp"

namespace vortree::sph {

/// Splits particles that are too coarse and merges those that are too fine, V against the volume W
/// that is wanted of them:
///
///   V > 2.8 W              into four, at +- s/4
///   V > 1.9 W              into two, at +- 0.3 s along the widest gap
///   V < 0.55 W             merged with the nearest with which it makes less than 1.5 W
///
/// wanted   spacing of each old particle [L] (adapt/wishes.hpp)
/// cost     O(n)
/// source   Muta & Ramachandran, Comput. Methods Appl. Mech. Engrg. 395 (2022), for mergers in
///          pairs
void refine(Population& population, const std::vector<double>& wanted);

/// Lets volumes follow how particles really stand, so that they go on filling the plane, without
/// gaps and once, and none stays much finer or coarser than its neighbors:
///
///   V <- V (1 + a (1 - filling) + b (mean_j(V_j/W_j) W/V - 1)),   a = 0.2, b = 0.1
///
/// j the neighbors. Those that see the outer boundary, where nothing is beyond it, have only the
/// second part; its nodes count as V = W.
void correct_volumes(Population& population, const std::vector<double>& wanted);

}  // namespace vortree::sph
