#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fmm/geometry/leaves.hpp"
#include "fmm/lists/lists.hpp"
#include "fmm/mutual/mutual_fixed_kernel.hpp"
#include "fmm/mutual/mutual_kernel.hpp"
#include "fmm/tuning.hpp"

namespace vortree::fmm {

/// Near sums of bare vortices in a run of childless cells: each cell with the members of
/// its U, both ways at once where both lie in the run.
class MutualNear {
 public:
  /// coarse   single precision will do: used wherever places fit (mutual_fixed_kernel.hpp); the
  ///          leaves come in vectors of floats
  MutualNear(const DeepTree& tree, const InteractionLists& lists, const Leaves& leaves,
             bool coarse);

  /// Adds to u and v (times 2 pi, in the places of leaves) all pairs of U with a target in the
  /// run of leaves.
  void add(tree::Range leaf_run, double* u, double* v);

 private:
  /// The first places of blocks of other cells, of as many as a vector holds.
  struct Blocks {
    std::vector<std::uint32_t> inside, outside;  // of the run of leaves
  };
  /// All that a cell meets but itself: in doubles, and in fixed point.
  struct Meeting {
    Blocks exact, fixed;
  };
  /// The points of a cell as the kernel for fixed point wants them; x = (position - x0) * scale.
  struct Fixed {
    double x0, y0, x_rest, y_rest, scale;
    Unwritten<std::int32_t> x, y;
    Unwritten<float> gamma;
    Unwritten<Singles> u, v;
  };

  void arrange(std::uint32_t leaf, tree::Range leaf_run, const MutualPoints& points,
               Meeting& meeting);
  void meet_exactly(std::uint32_t leaf, const Blocks& others, const MutualPoints& points);
  void meet_in_fixed(std::uint32_t leaf, const Blocks& others, const MutualPoints& points);
  void take(std::uint32_t leaf);
  template <bool both>
  void meet_block(std::uint32_t leaf, std::uint32_t block, const MutualPoints& points);
  template <bool both>
  void mend(std::uint32_t leaf, std::uint32_t block, const MutualPoints& points) const;

  const DeepTree& tree_;
  const InteractionLists& lists_;
  const Leaves& leaves_;
  bool coarse_;

  std::array<Meeting, cells_ahead + 1> meetings_;
  Unwritten<Lanes> u_, v_;
  Fixed room_;
};

}  // namespace vortree::fmm
