#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "fmm/geometry/cells.hpp"
#include "fmm/lists/interactions.hpp"
#include "tree/base/simd.hpp"

namespace vortree::fmm {

/// The targets of a cell in a row, filled up to whole vectors with the last one, and their sums.
struct Batch {
  TargetBox box;
  std::size_t size = 0;
  std::vector<double> x, y, core, u, v;

  void take(const SortedPoints& points, tree::Range range, const TargetBox& around) {
    box = around;
    size = range.size();
    const std::size_t whole = padded(size, single_count);
    for (auto* values : {&x, &y, &core}) values->resize(whole);
    for (auto* values : {&u, &v}) values->assign(whole, 0.0);
    for (std::size_t i = 0; i < whole; ++i) {
      const std::size_t from = range.first + std::min(i, size - 1);
      x[i] = points.x[from], y[i] = points.y[from], core[i] = points.core[from];
    }
  }
};

}  // namespace vortree::fmm
