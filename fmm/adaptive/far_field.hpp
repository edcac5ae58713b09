#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fmm/geometry/deep_tree.hpp"
#include "fmm/geometry/leaves.hpp"
#include "fmm/lists/lists.hpp"
#include "fmm/losses/charge.hpp"
#include "fmm/near/p2p_kernel.hpp"
#include "fmm/series/power_series.hpp"
#include "fmm/series/translation_kernel.hpp"
#include "tree/base/memory.hpp"

namespace vortree::fmm {

/// What the series need to know of the points and cells.
struct Stage {
  const DeepTree& tree;
  const InteractionLists& lists;
  const Leaves& leaves;
};

/// The multipoles and local expansions of all cells, about their centres and in lengths of their
/// sides (translation_kernel.hpp), in double or single precision.
template <class Number>
class FarField {
 public:
  FarField() = default;

  /// Multipoles: P2M in childless cells, M2M from level to level.
  FarField(const Stage& stage, TranslationTables<Number> tables);

  /// Local expansions: L2L, M2L, P2L from level to level.
  void descend(const Stage& stage);

  /// Adds the velocities (times 2 pi) of a cell's local expansion, or of its multipole, at targets.
  /// Their places must be readable up to whole vectors.
  void l2p(const Stage& stage, std::uint32_t cell, const NearTargets& targets) const;
  void m2p(const Stage& stage, std::uint32_t cell, const NearTargets& targets) const;

  /// The multipole and the local expansion of a cell.
  [[nodiscard]] SeriesView<Number> view_multipole(std::size_t cell) const {
    return {multipole(cell), multipole(cell) + padded_, tables_.order};
  }
  [[nodiscard]] SeriesView<Number> view_local(std::size_t cell) const {
    return {local(cell), local(cell) + padded_, tables_.order};
  }

  /// Of every cell.
  [[nodiscard]] std::span<const Charge> charges() const { return charges_; }

  [[nodiscard]] int order() const { return tables_.order; }
  [[nodiscard]] std::size_t bytes() const {
    return sizeof(Number) * (multipoles_.capacity() + locals_.capacity()) +
           sizeof(Charge) * charges_.capacity();
  }

 private:
  using Series = Unwritten<Number>;
  struct Families;

  [[nodiscard]] std::size_t stride() const { return 2 * static_cast<std::size_t>(padded_); }
  [[nodiscard]] Number* multipole(std::size_t cell) { return &multipoles_[cell * stride()]; }
  [[nodiscard]] const Number* multipole(std::size_t cell) const {
    return &multipoles_[cell * stride()];
  }
  [[nodiscard]] Number* local(std::size_t cell) { return &locals_[cell * stride()]; }
  [[nodiscard]] const Number* local(std::size_t cell) const { return &locals_[cell * stride()]; }

  template <class Use>
  void for_each_batch(const Stage& stage, int level, std::size_t worth_sharing, Families& spare,
                      const Use& use);
  void add_points(const Stage& stage, std::uint32_t cell);
  void add_children(const Stage& stage, Families& families);
  void add_far(const Stage& stage, std::uint32_t cell);
  void set_effective_charge(std::uint32_t cell);
  void meet_families(const Stage& stage, Families& families);

  TranslationTables<Number> tables_;
  int padded_ = 0;
  Series multipoles_, locals_;
  std::vector<Number> charge_weights_;
  Unwritten<Charge> charges_;
};

}  // namespace vortree::fmm
