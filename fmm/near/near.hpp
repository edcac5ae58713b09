#pragma once

#include <span>

#include "fmm/field/field.hpp"
#include "fmm/geometry/cells.hpp"
#include "fmm/lists/interactions.hpp"
#include "fmm/losses/near_errors.hpp"
#include "fmm/near/p2p_kernel.hpp"
#include "fmm/near/p2p_single_kernel.hpp"
#include "fmm/near/packed.hpp"

namespace vortree::fmm {

/// The near sums of one target leaf.
///
/// Sources of the near runs are packed side by side, and those of cells whose cores may show are
/// parted anew: most of them are still too far from this leaf for their own core to show there.
class NearSources {
 public:
  /// Collects the runs found.
  void pack(const SortedPoints& points, std::span<const double> gamma, const TargetBox& leaf,
            const Acceptance& acceptance, const Interactions& found);

  [[nodiscard]] std::size_t bare() const { return bare_.size() + hidden_.size(); }
  [[nodiscard]] std::size_t cored() const { return cored_.size(); }

  /// Adds all of them at the targets. coarse: single precision is exact enough, where it is safe.
  template <class Pair>
  void sum(const TargetBox& leaf, const NearTargets& targets, bool coarse) {
    p2p<BarePair>(bare_, targets);
    if (coarse && fits_single()) {
      const SingleFrame frame{leaf.x, leaf.y, size_};
      sum_single<BarePair>(hidden_, frame, targets);
      sum_single<Pair>(cored_, frame, targets);
    } else {
      p2p<BarePair>(hidden_, targets);
      for (std::size_t j = 0; j < padded(cored_.size()); ++j) {
        cored_.core()[j] = Pair::packed_core(cored_.core()[j]);
      }
      p2p<Pair>(cored_, targets);
    }
  }

  /// The same with a field's own sums (field.hpp).
  template <class Field>
  void sum(const Field& field, CoreShares shares, const FieldTargets& targets) const {
    field.add_bare(bare_, targets);
    field.add_bare(hidden_, targets);
    field.add_cored(cored_, shares, targets);
  }

  /// What the sum of all of them is expected to lose at a target.
  [[nodiscard]] Lost lost(double reach2, int derivative, bool coarse) const {
    const NearErrors near{.own = squares_,
                          .squares = squares_,
                          .side2 = size_ * size_,
                          .own_core = least_core_,
                          .least_core = least_core_,
                          .widest_core = widest_core_};
    if (squares_ == 0.0 || size_ == 0.0) return {};
    Lost lost = near.faded(reach2, derivative);
    if (coarse && fits_single()) lost += near.rounding(derivative);
    return lost;
  }

 private:
  void part(const SortedPoints& points, std::span<const double> gamma, const TargetBox& leaf,
            const Acceptance& acceptance, std::span<const tree::Range> runs);

  template <class Pair>
  void sum_single(const PackedSources& sources, const SingleFrame& frame,
                  const NearTargets& targets) {
    single_.assign<Pair>(sources, frame);
    p2p_single<Pair>(single_, targets);
  }

  /// Cores wide enough for the frame, and none beyond the range of floats. Hidden sources, too, are
  /// then far enough: their distance is several of their cores.
  [[nodiscard]] bool fits_single() const {
    return size_ > 0.0 && size_ * size_ <= widest_frame2 * least_core_ &&
           widest_core_ <= 1e30 * size_ * size_;
  }

  PackedSources bare_, hidden_, cored_;
  SinglePacked single_;
  double size_ = 0.0;  // no parted source or target is farther from the middle, in x or in y
  double least_core_ = 0.0, widest_core_ = 0.0;
  double squares_ = 0.0;  // sum gamma^2 of the parted
};

/// `use<Pair>()` with what sums pairs with cores.
template <class Use>
void with_pair(Cores cores, bool coarse, Use use) {
  if (cores == Cores::mean) {
    if (coarse) return use.template operator()<MeanCorePair<CoarseExp>>();
    return use.template operator()<MeanCorePair<FineExp>>();
  }
  if (coarse) return use.template operator()<SourceCorePair<CoarseExp>>();
  use.template operator()<SourceCorePair<FineExp>>();
}

}  // namespace vortree::fmm
