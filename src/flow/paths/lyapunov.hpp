#pragma once

#include <span>
#include <vector>

#include "flow/paths/flow_map.hpp"

namespace vortree::flow {

/// Finite-time Lyapunov exponents at the points of a grid, row by row [1/T]; nan where they are not
/// known.
struct LyapunovField {
  double from = 0, to = 0;
  PictureGrid grid{};
  std::vector<double> exponent{};
};

/// How fast fluid that begins near a place is drawn apart between two times, as the pictures of a
/// flow tell it:
///
///   lambda = ln sqrt(largest eigenvalue of F^T F)/|to - from|,   F = d X(to)/d X(from)
///
/// Forward in time ridges of lambda repel the fluid, backward (to < from) they attract it: these
/// are what dye shows. F is found by differences of four tracers, `offset` from the place along x
/// and y. Where one of them leaves the window or enters a body, lambda is not known. A steady
/// translation of the frame, or one that follows a body, changes no number.
///
/// grid    of the places, anywhere
/// offset  [L]; what is narrower than that is missed
/// error   of F: O(offset^2), and that of flow_map over the offset
/// source  Haller, Physica D 149 (2001); Shadden, Lekien & Marsden, Physica D 212 (2005)
/// throws  std::invalid_argument as flow_map, or if from == to
[[nodiscard]] LyapunovField lyapunov(std::span<const VelocityPicture> pictures,
                                     const VelocityAnywhere& velocity, const PictureGrid& grid,
                                     double offset, double from, double to);

/// The grid of tracers that fills the window of pictures.
[[nodiscard]] PictureGrid tracers_within(const PictureGrid& window, double spacing);

}  // namespace vortree::flow
