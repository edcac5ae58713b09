#pragma once

#include "vortex/cores/folded_centroid.hpp"

namespace vortree::vortex {

/// What a flow without body and force keeps: circulation and impulse; the second moment grows by
/// 4 nu t times the circulation.
///
///   circulation = sum gamma                         [m^2/s]
///   moment      = sum gamma X                       [m^3/s]; impulse = (moment.y, -moment.x)
///   second      = sum gamma (|X|^2 + sigma^2)       [m^4/s]
///
/// X the folded centroid. Sums are compensated (Neumaier), so that a drift seen is a drift.
struct Invariants {
  double circulation;
  Vec2 moment;
  double second;

  Vec2 impulse() const { return {moment.y, -moment.x}; }
};

Invariants invariants(const Blobs& blobs, const body::Shape* wall);
Invariants invariants(const Blobs& blobs, const FoldedBlobs& at);

}  // namespace vortree::vortex
