#pragma once

#include <memory>

#include "body/shape.hpp"

namespace vortree::body {

/// The section of Joukowski about the middle of its chord, the nose towards -x, turned nose up by
/// incidence (radians): what z = zeta + 1/zeta makes of a circle around 1 and -1,
///
///   zeta = i h - e + a exp(i t),   a = |1 + e - i h| + g.
///
/// Through 1 itself, g = 0, z has a cusp there; a circle that passes it at the distance g leaves a
/// rounded edge, of radius 2 g^2 for small g.
///
/// chord      its extent along x
/// thickness  the largest of the section of these e and g without camber, h = 0
/// camber     2 h of a chord of 4: the height of the arc that is left with e = g = 0
/// edge       radius of the edge, as a share of the chord, again without camber
/// throws     std::invalid_argument unless chord > 0, 1e-4 <= edge <= 0.02, 0 <= camber <= chord/4,
///            and thickness lies between that of e = 0 (thinnest_joukowski) and chord/2
/// source     Joukowski, Z. Flugtechnik Motorluftschiffahrt 1 (1910)
std::unique_ptr<Shape> joukowski(Vec2 centre, double chord, double thickness, double camber,
                                 double edge, double incidence);

/// The least thickness, in chords, that leaves an edge of that radius: an ellipse's, 2 sqrt(edge/2)
/// for a small one.
double thinnest_joukowski(double edge);

}  // namespace vortree::body
