#pragma once

#include <cstdint>
#include <vector>

#include "fmm/blobs.hpp"
#include "fmm/cells.hpp"
#include "fmm/order.hpp"
#include "tree/quadtree.hpp"

namespace vortree::fmm {

/// A cell met by its series.
struct SeriesCell {
  std::uint32_t cell;
  int terms;
};

/// What one target leaf meets: every source once, in a series cell or in a near run.
///
/// series   cells whose multipoles converge at the leaf, and whose cores no longer show there
/// bare     runs of sources to sum one by one whose cores no longer show
/// cored    runs of sources to sum one by one whose cores may show
struct Interactions {
  std::vector<SeriesCell> series;
  std::vector<tree::Range> bare, cored;

  void clear() { series.clear(), bare.clear(), cored.clear(); }
};

/// The targets of a leaf: bounding box and largest squared core.
struct TargetBox {
  double x, y, half_x, half_y, core;
};

/// When two cells may meet.
///
/// order    the ratio (cell radius)/(distance from its centre to the box) up to which it converges
/// reach2   a core S shows up to a gap of sqrt(reach2 S) between two boxes; 0: cores are ignored
struct Acceptance {
  Order order;
  double reach2 = 0;
  Cores cores = Cores::source;

  /// A tolerance of tol asks reach2 = ln(1/tol): beyond, exp(-r^2/S) <= tol.
  [[nodiscard]] double squared_reach(double source_core, double target_core) const {
    return reach2 * (cores == Cores::source ? source_core : 0.5 * (source_core + target_core));
  }
};

/// Walks the source tree from the root: a cell that may not be met by its series is opened; one
/// without children goes to the near runs. Small cells are summed directly when that is cheaper.
/// The walk is the paper's box-to-point evaluation; `found` is overwritten.
///
/// cost    O(log n) cells for n sources
/// source  Huang, Huang, Xu & Hu 2012; Barnes & Hut, Nature 324 (1986) for the walk
void find_interactions(const tree::Quadtree& tree, const CellShapes& shapes,
                       const TargetBox& target, const Acceptance& acceptance, Interactions& found);

}  // namespace vortree::fmm
