#pragma once

namespace vortree::sph {

/// Backward differences of second order along paths, for steps of any length:
///
///   du/dt = (b0 u^{n+1} - b1 u^n + b2 u^{n-1})/dt,   w = dt/(dt before)
///   b0 = (1 + 2 w)/(1 + w),  b1 = 1 + w,  b2 = w^2/(1 + w);   first step: 1, 1, 0
///
/// and the velocity that carries particles, u at the middle of the step: (1 + w/2) u^n - w/2
/// u^{n-1}.
struct TimeStep {
  double dt = 0;
  double ratio = 0;  ///< w; 0 in the first step

  [[nodiscard]] double b0() const { return (1 + 2 * ratio) / (1 + ratio); }
  [[nodiscard]] double b1() const { return 1 + ratio; }
  [[nodiscard]] double b2() const { return ratio * ratio / (1 + ratio); }
  [[nodiscard]] double middle(double now, double before) const {
    return (1 + ratio / 2) * now - ratio / 2 * before;
  }
};

}  // namespace vortree::sph
