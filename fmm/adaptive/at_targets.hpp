#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fmm/adaptive/adaptive.hpp"
#include "fmm/boxes/batch.hpp"

namespace vortree::fmm {

/// Place of a target that no cell holds.
inline constexpr std::uint32_t outside = 0xffffffffu;

/// A target and the smallest cell that holds it.
struct Held {
  std::uint32_t cell, index;
};

/// Targets in groups of one cell that are summed together: those of group b are
/// held[first[b]] .. held[first[b + 1] - 1].
struct Adaptive::Groups {
  std::vector<Held> held;
  std::vector<std::size_t> first;

  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
  [[nodiscard]] std::span<const Held> operator[](std::size_t b) const {
    return std::span(held).subspan(first[b], first[b + 1] - first[b]);
  }
};

/// What a group of targets meets beside the local expansion of the cell that holds it.
struct Adaptive::Elsewhere {
  std::vector<std::uint32_t> open, series;
  Interactions near;
  NearSources sources;
  Batch batch;

  void restart() { open.clear(), series.clear(), near.clear(); }
};

/// The targets of a group, filled up to whole vectors with the last one; sums at zero.
void take(const Targets& targets, const Units& units, std::span<const Held> held, Batch& batch);

}  // namespace vortree::fmm
