#pragma once

#include "body/shape.hpp"
#include "sph/cloud/cloud.hpp"
#include "tree/neighbors/pair_list.hpp"

namespace vortree::sph {

/// Whether a body stands between two places outside of it: the segment from one to the other enters
/// the body and leaves it through a side that faces away from where it entered. One that only cuts
/// a bend of the wall, as between two of its nodes, does not count.
///
/// error   a body thinner than 1e-6 of the segment is not seen
/// cost    some ten distances to the wall
/// source  Belytschko, Krongauz, Organ, Fleming & Krysl, Comput. Methods Appl. Mech. Engrg. 139
///         (1996), 3, section 7: the visibility criterion
[[nodiscard]] bool hidden(const body::Shape& shape, Vec2 from, Vec2 to);

/// Takes those pairs out of lists that hold them both ways. Those are asked that have the wall in
/// their reach: nodes, rings, and free particles where rings are too few to keep them away.
///
/// reach  of a particle [spacings]
/// cost   that of hidden() for those that are back to back, and of a glance at the wall for each
///        free particle
void keep_in_sight(tree::PairList& rows, const Cloud& cloud, const body::Shape& shape,
                   double reach);

}  // namespace vortree::sph
