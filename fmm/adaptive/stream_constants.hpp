#pragma once

#include <vector>

#include "fmm/adaptive/far_field.hpp"

namespace vortree::fmm {

/// The constants that the local expansions of f lack when f is integrated: of every cell the sum
///
///   sum_j gamma_j ln |centre - z_j|^2   over all j that the cell's local expansion stands for
///
/// From the root downward: at the centre of a child the parent's integral counts what its own
/// expansion stands for, the multipoles of V and the points of X what the child's adds.
///
/// cost    O(cells order); the children of a cell meet those of its neighbors together, one to a
///         lane
template <class Number>
[[nodiscard]] std::vector<double> stream_constants(const Stage& stage, const FarField<Number>& far);

}  // namespace vortree::fmm
