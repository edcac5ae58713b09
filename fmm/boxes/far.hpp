#pragma once

#include <span>
#include <vector>

#include "fmm/boxes/batch.hpp"
#include "fmm/geometry/cells.hpp"
#include "fmm/lists/interactions.hpp"
#include "fmm/losses/expected.hpp"
#include "fmm/series/multipoles.hpp"

namespace vortree::fmm {

/// What series are expected to lose at a target, of f, a derivative of it (1) or its integral (-1).
/// Terms were chosen for the tolerance of (charge / distance) (order.hpp).
[[nodiscard]] Lost lost_by_series(const Multipoles& multipoles, const Acceptance& acceptance,
                                  std::span<const SeriesCell> series, int derivative);

/// Sums of series at the targets of a block or leaf.
class FarSums {
 public:
  /// Adds the velocities (times 2 pi) of the series cells. In single precision if the multipoles
  /// are held in it, but for cells too small against the batch for its range.
  void add(const CellShapes& shapes, const Multipoles& multipoles,
           std::span<const SeriesCell> series, Batch& batch);

 private:
  void take_single(const Batch& batch);

  std::vector<float> x_, y_;  // targets from the middle of the batch, in lengths of size_
  double size_ = 1.0;
};

}  // namespace vortree::fmm
