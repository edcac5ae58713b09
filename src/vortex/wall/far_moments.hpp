#pragma once

#include <span>
#include <vector>

#include "base/vec2.hpp"
#include "vortex/wall/three_points.hpp"

namespace vortree::vortex {

/// The slip that cores near the wall cause far along it by being three points instead of one.
///
/// Cores are gathered at the middle c_j of the nearest panel. The average velocity along panel i,
/// from z_i to z_(i+1), of those gathered at more than `aside` panels from it is
///
///   (P(z_(i+1)) - P(z_i))/b_i, P(z) = 1/(2 pi) Im sum_j sum_k M_jk/(z - c_j)^k,   2 <= k <= K
///   M_jk = -sum gamma outer/k (((d + arm)^k + (d - arm)^k)/2 - d^k),   d = z_core - c_j
///
/// error   of each core's part, of the order of (|d +- arm|/|z - c_j|)^(K+1), K = 9: six panels and
///         a half away 1e-5 of cores as wide as a panel, 0.2 % of those that reach 3.5 panels
/// cost    O(K panels^2); setting up O(panels^2)
class FarMoments {
 public:
  FarMoments(std::span<const Vec2> edge, std::span<const Vec2> middle,
             std::span<const double> length, std::size_t aside);

  /// Whether the series converge of what reaches so far from a panel: to 3.5 panels, but not more
  /// than 0.6 of the way to the nearest panel that is not close along the wall: the other side of a
  /// thin body may be.
  bool serves(std::size_t panel, double reach) const { return reach <= reach_[panel]; }

  /// M of all panels, of no core yet.
  std::vector<double> none() const;

  /// Adds a core to the moments of a panel.
  void gather(Vec2 at, const ThreePoints& points, double gamma, std::size_t panel,
              std::span<double> moments) const;

  void add_slip(std::span<const double> moments, std::span<double> slip) const;

  /// The same along panels of another body, which runs through these edges.
  void add_slip_elsewhere(std::span<const double> moments, std::span<const Vec2> edge,
                          std::span<const double> length, std::span<double> slip) const;

 private:
  class Columns;
  double clear(std::size_t panel) const;

  std::size_t panels_, aside_;
  std::vector<Vec2> edge_, middle_;
  std::vector<double> length_, reach_;
};

}  // namespace vortree::vortex
