#pragma once

#include <algorithm>
#include <span>

#include "fmm/sources.hpp"

namespace vortree::fmm {

struct SourceBounds;

/// Powers of two that bring lengths and circulations near one, so that no square or product inside
/// a sum over- or underflows, whatever the user's units. Scaling by them rounds nothing.
///
/// What lies below least_length or beyond the widest core leaves the range of squares of squares:
/// the doors refuse it (check), or what it moves does not count.
struct Units {
  double per_length = 1.0, per_gamma = 1.0;

  /// The units in which the extent of the blobs and their largest |gamma| are near one.
  static Units of(const SourceBounds& bounds);
  static Units of(const Sources& sources);

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

  /// throws   std::invalid_argument if a velocity (derivative 0), gradient (1) or stream function
  ///          (-1) cannot be told in the user's units: sums of n targets whose squares add up to
  ///          `found` over- or underflow
  void check_range(double found, std::size_t n, int derivative) const;

  /// Velocities at targets beyond far_away, where the blobs are one vortex of all their
  /// circulation, in Units: in the user's units, in place of what is there.
  void finish_far(double all, std::span<const double> x, std::span<const double> y,
                  std::span<double> u, std::span<double> v) const;

  static constexpr double far_away = 1e70;          // a target beyond sees one vortex (finish_far)
  static constexpr double largest_core = 1e120;     // squared; wider ones count as that wide
  static constexpr double least_length = 0x1p-220;  // 6e-67; its square is 1e17 times `tiny`
};

}  // namespace vortree::fmm
