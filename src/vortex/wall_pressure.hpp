#pragma once

#include <span>
#include <vector>

#include "vortex/step.hpp"

namespace vortree::vortex {

/// Pressure at the middle of each panel beyond that far away, per unit density [m^2/s^2].
///
/// Along the wall it is the integral of its slope in the frame of the body, less what drives the
/// fluid with that frame, X''.x. Its level follows from velocity and vorticity of one time, exactly
/// and however the flow changes. By the momentum equation in the form of Lamb and Gromeka
///
///   lap h = div(u x omega),   h = p + |u|^2/2 - |U|^2/2 -> 0 far away,
///
/// U the stream and u the velocity as the body's centre sees them. Let Phi be harmonic outside the
/// body, 0 on it and as ln r far away; turned by a quarter, grad Phi is the flow V that circles the
/// body with circulation 2 pi, and w = dPhi/dn its speed on the wall. Green's second identity of h
/// and Phi leaves no unknown, since neither dh/dn nor a rate of change is weighted by more than 0:
///
///   1/(2 pi) oint w h ds = -1/(2 pi) int omega u.V dA
///                        = -1/(2 pi) sum gamma_i (u_i.V(x_i) + C_km d_k u_l d_m V_l),
///
/// u_i and its gradient the means over a core, C its covariance; and on the wall u is that of the
/// body. (Of a circle w = 1/R: the mean of the pressure.)
///
/// Of several bodies each has a Phi of its own, which is constant on every one of them, and whose
/// flow V circles it alone: Phi then weights sums of dh/dn - (u x omega).n around bodies, which are
/// minus the rate of change of what flows through their walls, 0.
///
/// slope  dp/ds along each panel (slope_at_end)
/// error  of the level: O(core^2); 0.0019 U^2 where cores that are released are a seventh of a
///        layer sqrt(4 nu t), 0.0010 where they are a tenth (tests/vortex/wall_pressure.cpp); of
///        the slope O(dt^2)
/// cost   that of one velocity of all blobs with its gradient, and two of the sheet for each body
std::vector<double> wall_pressure(const Blobs& blobs, const Problem& problem,
                                  std::span<const double> slope);

/// Means of dp/ds along each panel over the last step and over the one before, if there is one
/// (Wake::pressure_slope).
struct SlopeMeans {
  std::span<const double> last, before;
};

/// dp/ds along each panel at `time`, the end of a step dt: the rate of change of what both means
/// have given, by a parabola in t, or after an impulsive start in sqrt(t), which is exact of
/// 1/sqrt(t); of the first step of all by a line.
/// error  dt^2/3 of the second rate of change, of the first step O(dt); of noise that the means do
///        not share 1.6 times theirs
std::vector<double> slope_at_end(const SlopeMeans& known, double time, double dt, bool impulsive);

/// The integral of a slope around each body, from anywhere on; what would not close is spread
/// evenly.
std::vector<double> integrated(const Wall& wall, std::span<const double> slope);

/// 1/(2 pi) oint w p ds of that pressure, of the first body.
double pressure_level(const Blobs& blobs, const Problem& problem);

}  // namespace vortree::vortex
