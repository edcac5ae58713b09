#pragma once

#include <algorithm>

#include "base/vec2.hpp"

namespace vortree::sph {

/// The force of the pressure without its noise. Particles that come, split and merge change the
/// pressure of a step by about their error in velocity times spacing over dt, white in time; the
/// force by vorticity (vorticity_force.hpp) is smooth, but off by some percent as the spacing is
/// coarse. So
///
///   F = F_vorticity + 2 E[d] - E[E[d]],   d = F_pressure - F_vorticity,
///
/// E the exponential mean over the last `memory`: right in the mean as the pressure is, smooth as
/// the vorticity is. The second mean takes out what E lags behind.
///
/// error  the noise of the pressure times sqrt(5 dt/(4 memory)), and memory^2 d''
/// source Brown, Smoothing, Forecasting and Prediction (1963), chapter 9, for the double mean
class SmoothPressure {
 public:
  /// The mean of a step of dt.
  Vec2 operator()(Vec2 pressure, Vec2 by_vorticity, double dt, double memory);

  Vec2 mean{}, mean_of_means{};  // to be saved
};

/// Long beside a step, short beside the age of a flow that starts at once, and beside the period of
/// a motion [T].
///
/// unit       length of the body over speed [T]
/// frequency  of the motion; 0: none
inline double memory_of_pressure(double age, double unit, double frequency) {
  const double most = std::min(age / 8, unit / 4);
  return frequency > 0 ? std::min(most, 0.02 / frequency) : most;
}

}  // namespace vortree::sph
