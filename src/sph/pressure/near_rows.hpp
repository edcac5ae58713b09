#pragma once

#include "sph/pressure/sliced_rows.hpp"

namespace vortree::sph {

/// A without the entries of a row that are less than `small` of the largest beside the diagonal,
/// for all that need A only roughly: of some 22 neighbors by moving least squares half go.
///
/// What goes is put on those that stay, as much of it as they have, and the diagonal keeps the sum
/// of the row: a wave that is long beside the spacing is then as strong as before within a tenth,
/// though those that go are farther away.
///
/// a       a diagonal first in each row
/// cost    A is read twice, half of it written
void near_rows(const SlicedRows& a, SlicedRows& near);

}  // namespace vortree::sph
