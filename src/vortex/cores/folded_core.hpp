#pragma once

#include <algorithm>
#include <cmath>

namespace vortree::vortex {

/// A Gaussian core next to a wall, folded: the part that would lie in the body is reflected into
/// the fluid.
///
/// For a flat wall this is the exact heat flow without flux, so that sigma^2 += 4 nu dt stays the
/// right diffusion and all circulation stays in the fluid. With y the distance of the centre to the
/// wall,
///
///   mean distance      m   = s/sqrt(pi) exp(-q^2) + y erf(q) - kappa s^2/8 c(q),   q = y/s,
///                      c   = (1 - 2 q^2) erfc(q) + 2 q/sqrt(pi) exp(-q^2)
///   variance across    v_n = s^2/2 + y^2 - m^2              (the s^2/2 of a free core, far away)
///   wall vorticity     omega(x_w) = 2 gamma/(pi s^2) exp(-|x - x_w|^2/s^2)
///
/// where kappa is the curvature of the wall (first order; convex > 0) [1/m]: a walk reflected at a
/// bent wall that first meets it at T is pushed less by kappa nu E[(t + T)/2; T < t]. An edge
/// sharper than a core counts as 4/(sqrt(pi) s), which halves the mean distance of a core on the
/// wall, and no more. A blob acts, and is moved, at its mean; further than `support` cores from the
/// wall it is a free blob.
namespace folded {

constexpr double support = 4;  // cores; erfc(4) = 1.5e-8
constexpr double inverse_sqrt_pi = 0.56418958354775628695;
constexpr double thinnest = 0.2;  // of s/sqrt(pi): how far a core may be squeezed in one move

inline bool applies(double y, double s) {
  return y < support * s;
}

/// A core of width 1 at a distance q from a flat wall: exp(-q^2)/sqrt(pi) + q erf(q), and its first
/// two derivatives, erf(q) and 2/sqrt(pi) exp(-q^2).
/// error  5e-16 to |q| = support: Taylor series about the nearest 64th, from a table; 2e-8 for any
///        other q, of which they are |q|, its sign and 0; no number of what is none
struct Profile {
  double mean, erf, slope;
};
Profile profile(double q);

/// What a curved wall takes from the mean distance of a core on it, in cores.
inline double bend(double s, double kappa) {
  return std::min(kappa * s / 8, inverse_sqrt_pi / 2);
}

inline double mean_distance(double y, double s, double kappa) {
  if (!applies(y, s)) return y;
  const double q = y / s;
  const Profile at = profile(q);
  return s * (at.mean - bend(s, kappa) * ((1 - 2 * q * q) * (1 - at.erf) + q * at.slope));
}

inline double variance_across(double y, double s, double m) {
  return s * s / 2 + y * y - m * m;
}

/// What is folded: a Gaussian by the distance of its centre and its width.
struct Gaussian {
  double y, s;
};

/// The core whose mean distance is m: the centre is found for the given s; where even a centre on
/// the wall lies too far out (m < s/sqrt(pi)), the core is squeezed, never below `thinnest` of it.
Gaussian place(double m, double s, double kappa);

/// The core whose mean distance is m and whose variance across the wall is v_n. A wider
/// distribution than that of a centre on the wall, v_n > (pi/2 - 1) m^2, is none of a folded core:
/// it gets the mean alone. No mean is nearer than `thinnest` sqrt(2 v_n/pi).
///
/// error  1e-9 of the mean; of v_n 1e-8 at a flat wall, 1e-6 at a bent one
///        (tests/vortex/cores/folded_centroid.cpp)
Gaussian place_with_variance(double m, double v_n, double kappa);

}  // namespace folded
}  // namespace vortree::vortex
