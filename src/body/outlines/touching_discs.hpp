#pragma once

#include <vector>

#include "body/shape.hpp"

namespace vortree::body {

/// Radii of the largest discs that touch an outline at the places of its trace and cross it
/// nowhere, of the two within and without the smaller one:
///
///   1/r(x) = max over x' of 2 |n.(x - x')|/|x - x'|^2,   |curvature| for x' -> x,
///
/// 4 pi times the largest that the wall's kernel K(x, x') is there. It is the radius of curvature
/// of a tip, half the thickness of what is thin, half the width of a notch; R all around a circle,
/// and (b/a) |d(x, y)/dt| along the ellipse (a cos t, b sin t), b < a.
///
/// error  the discs are asked of the places alone
/// cost   0.5 ms
[[nodiscard]] std::vector<double> touching_discs(const Shape& shape,
                                                 const std::vector<OutlinePoint>& trace);

}  // namespace vortree::body
