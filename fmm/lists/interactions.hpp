#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "fmm/geometry/cells.hpp"
#include "fmm/series/order.hpp"
#include "fmm/sources.hpp"
#include "tree/build/quadtree.hpp"

namespace vortree::fmm {

/// A cell met by its series.
struct SeriesCell {
  std::uint32_t cell;
  int terms;
  double per_distance2;  // one over the squared distance of its centre to the targets' box
};

/// What a block of neighbouring target leaves meets as one: every source is in a series cell or in
/// a waiting cell.
///
/// series    cells whose multipoles converge at the whole block, and whose cores do not show there
/// waiting   cells that each leaf must look at for itself
struct SharedInteractions {
  std::vector<SeriesCell> series;
  std::vector<std::uint32_t> waiting;

  void clear() { series.clear(), waiting.clear(); }
};

/// What one target leaf meets of the waiting cells: every source once.
///
/// series   cells whose multipoles converge at the leaf, and whose cores no longer show there
/// bare     runs of sources to sum one by one whose cores no longer show
/// cored    runs of sources to sum one by one whose cores may show
struct Interactions {
  std::vector<SeriesCell> series;
  std::vector<tree::Range> bare, cored;

  void clear() { series.clear(), bare.clear(), cored.clear(); }
};

/// The targets of a leaf or block: bounding box and largest squared core.
struct TargetBox {
  double x, y, half_x, half_y, core;
};

[[nodiscard]] inline TargetBox box(const CellShapes& shapes, std::size_t cell) {
  return {shapes.x[cell], shapes.y[cell], shapes.half_x[cell], shapes.half_y[cell],
          shapes.core[cell]};
}

/// r^2/S from which on a core counts as nothing:
///
///   reach2 = ln(1/tolerance)
///
/// Beyond, a pair is wrong by exp(-r^2/S) <= tolerance of itself.
[[nodiscard]] inline double core_reach2(double tolerance) {
  return std::log(1.0 / tolerance);
}

/// When two cells may meet.
///
/// order    the ratio (cell radius)/(distance from its centre to the box) up to which it converges
/// lost2    the square of the tolerance that the order was chosen by; 0: by none
/// reach2   a core S shows up to a gap of sqrt(reach2 S) between two boxes; 0: cores are ignored
struct Acceptance {
  SeriesOrder order;
  double reach2 = 0;
  Cores cores = Cores::source;
  double lost2 = 0;

  [[nodiscard]] double squared_reach(double source_core, double target_core) const {
    return reach2 * (cores == Cores::source ? source_core : 0.5 * (source_core + target_core));
  }
};

/// The two steps of the walk, which is the paper's box-to-point evaluation: from the root, a cell
/// that may not be met by its series is opened. For a block, cells no larger than the block are
/// left to its leaves. For a leaf, cells without children go to the near runs, and small cells are
/// summed directly where that is cheaper. What is found is overwritten.
///
/// cost    O(log n) cells for n sources
/// source  Huang, Huang, Xu & Hu 2012; Barnes & Hut, Nature 324 (1986) for the walk
void find_shared(const tree::Quadtree& tree, const CellShapes& shapes, const TargetBox& block,
                 const Acceptance& acceptance, SharedInteractions& found);
void find_interactions(const tree::Quadtree& tree, const CellShapes& shapes, const TargetBox& leaf,
                       const Acceptance& acceptance, std::span<const std::uint32_t> waiting,
                       Interactions& found);

}  // namespace vortree::fmm
