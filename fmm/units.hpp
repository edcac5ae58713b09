#pragma once

#include <span>

#include "fmm/blobs.hpp"

namespace vortree::fmm {

/// Powers of two that bring lengths and circulations near one, so that no square or product inside
/// a sum over- or underflows, whatever the user's units. Scaling by them rounds nothing.
///
/// Points nearer than 1e-75 lengths count as coincident, cores below that as bare.
struct Units {
  int length = 0;  // exponent of two of the unit, in the user's units
  int gamma = 0;

  /// The units in which the extent of the blobs and their largest |gamma| are near one.
  static Units of(const Blobs& blobs);

  [[nodiscard]] double position(double x) const;
  [[nodiscard]] double circulation(double gamma) const;
  [[nodiscard]] double squared_core(double sigma) const;

  /// u = sum / (2 pi) in the user's units, in place.
  void to_velocity(std::span<double> sums) const;
};

}  // namespace vortree::fmm
