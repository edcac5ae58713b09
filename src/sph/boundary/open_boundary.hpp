#pragma once

#include "sph/adapt/population.hpp"
#include "sph/boundary/outer_box.hpp"
#include "sph/boundary/standing_bodies.hpp"

namespace vortree::sph {

/// Where particles may be: in the box, and farther from bodies than their rings.
///
/// rings  beside each body, as far apart as nodes of its wall
struct Confines {
  OuterBox box;
  StandingBodies bodies{};
  int rings = 0;
};

/// Takes particles away that have come nearer than 0.35 s to the outer boundary, or than 0.45
/// spacings to the outermost ring; and of two nearer to each other than 0.4 s, the smaller.
void take_away(Population& population, const Confines& confines);

/// Puts particles into what gaps there are beside the outer boundary, 0.75 s inside of it, and
/// beside the outermost ring, a spacing away: wherever none is nearer than 0.8 s. What they carry
/// is the mean of all series around.
void fill_gaps(Population& population, const Confines& confines);

}  // namespace vortree::sph
