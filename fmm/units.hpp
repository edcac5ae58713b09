#pragma once

#include <algorithm>
#include <span>

#include "fmm/blobs.hpp"

namespace vortree::fmm {

/// Powers of two that bring lengths and circulations near one, so that no square or product inside
/// a sum over- or underflows, whatever the user's units. Scaling by them rounds nothing.
///
/// Points nearer than 1e-75 lengths count as coincident, cores below that as bare.
struct Units {
  double per_length = 1.0, per_gamma = 1.0;

  /// The units in which the extent of the blobs and their largest |gamma| are near one.
  static Units of(const Blobs& blobs);

  [[nodiscard]] double position(double x) const {
    return std::clamp(x * per_length, -far_away, far_away);
  }
  [[nodiscard]] double circulation(double gamma) const { return gamma * per_gamma; }
  [[nodiscard]] double squared_core(double sigma) const {
    const double scaled = sigma * per_length;
    return std::min(scaled * scaled, largest_core);
  }

  /// u = sum / (2 pi) in the user's units, in place.
  void to_velocity(std::span<double> sums) const;

  static constexpr double far_away = 1e70;       // a target beyond this sees no difference
  static constexpr double largest_core = 1e120;  // so wide, it moves nothing double can hold
};

}  // namespace vortree::fmm
