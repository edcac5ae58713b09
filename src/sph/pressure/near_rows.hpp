#pragma once

#include "sph/pressure/sliced_rows.hpp"

namespace vortree::sph {

/// A without the entries that are less than a fiftieth of what stands beside the diagonal of their
/// row (sums of magnitudes), for all that need A only roughly: of 22 neighbors by moving least
/// squares nearly half go.
///
/// Those that stay take over what goes, each in proportion, and the diagonal keeps the sum of the
/// row. A wave that is long beside the spacing is then as strong as before within a tenth, though
/// those that go are farther away.
///
/// a       a diagonal first in each row
/// cost    A is read twice, half of it written
void near_rows(const SlicedRows& a, SlicedRows& near);

}  // namespace vortree::sph
