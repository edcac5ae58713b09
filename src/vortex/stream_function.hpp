#pragma once

#include <vector>

#include "vortex/step.hpp"

namespace vortree::vortex {

/// Stream function of the velocity at points: u = d psi/dy, v = -d psi/dx, with
///
///   psi = U y - V x - sum_j gamma_j/(2 pi) (ln r + E1(r^2/sigma_j^2)/2)
///         - 1/(2 pi) int gamma ln r ds,
///
/// stream, blobs and sheet. Beside a wall a constant is taken away, so that the mean along the wall
/// is 0, of several bodies along that of the first: each wall is a streamline unless its body
/// turns, or moves against the first. Within a body psi goes on as that of its own motion, V_x y -
/// V_y x - rate |x|^2/2, beyond the mean of that along its wall. All circulation adds up to 0
/// there, so that psi - U y + V x fades with the distance; in free space r is in the unit of
/// positions.
///
/// returns  a value a point [m^2/s]
/// error    as Plan::stream_function, by stream_function_tolerance or that of the sums if it is
///          smaller; near a wall O(b^2) of the sheet (tests/vortex/stream_function.cpp)
/// cost     of stream functions of blobs and panels, O(blobs + points), and of a sheet
std::vector<double> stream_function_at(tree::Points points, const Blobs& blobs,
                                       const Problem& problem);

}  // namespace vortree::vortex
