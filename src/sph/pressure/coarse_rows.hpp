#pragma once

#include "sph/pressure/aggregates.hpp"
#include "sph/pressure/sliced_rows.hpp"

namespace vortree::sph {

/// Interpolation from aggregates, of order two: constants smoothed by a step of Jacobi with the
/// strong neighbors of a row (aggregates.hpp) alone,
///
///   (P c)_i = (1 - w) c_(of i) + w sum_j a_ij c_(of j) / sum_j a_ij,   j strong,   w = 0.66
///
/// Rows without aggregate get nothing. With w near 1 coarse matrices become singular.
///
/// source  Vanek, Mandel & Brezina, Computing 56 (1996)
void interpolate(const SlicedRows& a, const RowTies& ties, const RowAggregates& aggregates,
                 RowsMaker& maker, SlicedRows& p);

/// R A P, where R adds up the rows of an aggregate.
///
/// cost    a row of m values, of which the rows of an aggregate have half in common: 4 m sums
void coarse_rows(const SlicedRows& a, const SlicedRows& sums, const SlicedRows& p, RowsMaker& maker,
                 SlicedRows& coarse);

}  // namespace vortree::sph
