#pragma once

#include <span>

#include "fmm/cells.hpp"
#include "fmm/interactions.hpp"
#include "fmm/p2p_kernel.hpp"
#include "fmm/p2p_single_kernel.hpp"
#include "fmm/packed.hpp"

namespace vortree::fmm {

/// The near sums of one target leaf.
///
/// Sources of the near runs are packed side by side and parted anew: in a cell whose cores may
/// show, most sources are still too far from this leaf for their own core to show there.
class NearSources {
 public:
  /// Collects the runs found; cores still as squared sizes.
  void pack(const SortedPoints& points, std::span<const double> gamma, const TargetBox& leaf,
            const Acceptance& acceptance, const Interactions& found);

  [[nodiscard]] std::size_t bare() const { return bare_.size(); }
  [[nodiscard]] std::size_t cored() const { return cored_.size(); }

  /// Adds all of them at the targets. coarse: single precision is exact enough, where it is safe.
  template <class Pair>
  void sum(const TargetBox& leaf, const NearTargets& targets, bool coarse) {
    p2p<BarePair>(bare_, targets);
    if (cored_.size() == 0) return;
    const SingleFrame frame = frame_of(leaf);
    if (coarse && fits_single(frame, leaf.core)) {
      single_.assign<Pair>(cored_, frame);
      return p2p_single<Pair>(single_, targets);
    }
    for (std::size_t j = 0; j < padded(cored_.size()); ++j) {
      cored_.core()[j] = Pair::packed_core(cored_.core()[j]);
    }
    p2p<Pair>(cored_, targets);
  }

 private:
  void part(const SortedPoints& points, std::span<const double> gamma, const TargetBox& leaf,
            const Acceptance& acceptance, std::span<const tree::Range> runs);
  [[nodiscard]] SingleFrame frame_of(const TargetBox& leaf) const;
  [[nodiscard]] bool fits_single(const SingleFrame& frame, double target_core) const;

  Packed bare_, cored_;
  SinglePacked single_;
};

}  // namespace vortree::fmm
