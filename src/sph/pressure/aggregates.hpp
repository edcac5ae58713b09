#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sph/pressure/sliced_rows.hpp"

namespace vortree::sph {

/// How rows are tied to others. Of row i, j is a strong neighbor if
///
///   -a_ij / a_ii > 1/4 max_k -a_ik / a_ii
///
/// threshold   what -a_ij, times the sign of a_ii, has to exceed for that
/// sign        that neighbors have: the other one than a_ii
/// inverse     1 / a_ii, of Jacobi steps: where half the sum of magnitudes beside it is more than
///             |a_ii|, 1 / that, of the same sign
/// alone       less than a fifth of a_ii stands beside it: solved by its diagonal
struct RowTies {
  std::vector<float> threshold, sign, inverse;
  std::vector<char> alone;
};

void find_ties(const SlicedRows& a, RowTies& ties);

/// Rows put together for a coarser level: a row whose strong neighbors all are free founds an
/// aggregate with them; who is left joins the one that he is strongest to, and if there is none
/// founds one with who is free. Rows that are alone stay out.
///
/// of      the aggregate of a row, or -1
/// count   of aggregates; numbered in order of their first rows
/// source  Vanek, Mandel & Brezina, Computing 56 (1996)
struct RowAggregates {
  std::vector<std::int32_t> of;
  std::size_t count = 0;
};

RowAggregates aggregate(const SlicedRows& a, const RowTies& ties);

/// The rows of each aggregate: a matrix of ones, which adds them up.
void sum_over(const RowAggregates& aggregates, RowsMaker& maker, SlicedRows& sums);

}  // namespace vortree::sph
