#pragma once

#include <vector>

#include "body/shape.hpp"

namespace vortree::body {

/// How long panels may be along an outline: 0.7 of the radius of curvature, 1.25 of that of the
/// disc that touches there (touching_discs.hpp), and no more than 0.3 longer for each length along
/// the wall, so that neighbors differ by less than a third.
///
/// Of `needed` panels all are as long as they may be. More of them have all limits L shorter by
/// sqrt(needed/panels), and are besides no longer than h where nothing bends,
///
///   panels = int ds/min(h, L sqrt(needed/panels)),
///
/// so that twice as many are finer everywhere; with fewer all limits are stretched alike.
///
/// Sheets of a stream past ellipses of 5 : 1 to 50 : 1, which need 35 to 262, err by 5e-4 to 2e-3
/// of their largest with as many as are needed, by 1e-4 to 4e-4 with half as many more, by 1e-5 to
/// 6e-5 with twice as many; around the edges of foils by 5e-3, 4e-4 to 2e-3 and 2e-4
/// (tests/vortex/wall/graded.cpp). With 1 radius of curvature they err by ten times as much; with
/// 1.5 radii of the disc needs are a tenth less, and thin ellipses err by three times as much.
class PanelLimits {
 public:
  explicit PanelLimits(const Shape& shape);

  [[nodiscard]] double needed() const { return needed_; }

  /// The longest of so many panels [L]: h, or what limits allow where that is less.
  [[nodiscard]] double longest_of(double panels) const;

  /// How many have this h, and are as many as needed: perimeter/h where limits are longer.
  [[nodiscard]] double panels_with(double h) const;

  /// Of so many panels, the arcs where each begins, from 0 on, and the perimeter [L].
  [[nodiscard]] std::vector<double> edges(int panels) const;

 private:
  struct Side {
    double arc, length, begin, end;  // the limit at its beginning and end
  };
  /// perimeter/h times this many panels are no longer than h, nor than a share of the limits.
  [[nodiscard]] double crowding(double h, double share) const;
  [[nodiscard]] double share_of(double panels) const;

  std::vector<Side> sides_;
  double perimeter_, needed_ = 0, farthest_ = 0;  // the longest limit
};

}  // namespace vortree::body
