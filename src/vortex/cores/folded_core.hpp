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
///   variance across    v_n = s^2/2 + y^2 - m^2 - kappa s^3/(6 sqrt(pi)) g(q)
///                      g   = (1 - 2 q^2) exp(-q^2) + 2 sqrt(pi) q^3 erfc(q)
///                                                           (the s^2/2 of a free core, far away)
///   sag                e   = kappa/2 (v_t - s^2/2)
///   wall vorticity     omega(x_w) = 2 gamma/(pi s^2) exp(-|x - x_w|^2/s^2)
///
/// where kappa is the curvature of the wall (first order; convex > 0) [1/m]. Mean and variance are
/// those of places in the plane, seen from the tangent at the nearest wall point, not of distances
/// from the wall. A walk reflected at a bent wall that first meets it at T is pushed less by kappa
/// nu E[(t + T)/2; T < t], and its mean square by the t^2 by which the wall has fallen back where
/// it is pushed, kappa nu int <t^2> omega(0). An edge sharper than a core counts as
/// 4/(sqrt(pi) s), which halves the mean distance of a core on the wall, and no more.
///
/// A core that is drawn out along the wall to a variance v_t beyond its own s^2/2 follows it: its
/// centre and its mean lie by the sag behind those of a round core at the same distance. So what is
/// split and merged along a bent wall keeps its distance.
///
/// A blob acts, and is moved, at its mean; further than `support` cores from the wall it is a free
/// blob.
/// error   O((kappa s)^2) of mean and variance (tests/vortex/cores/bent_wall.cpp)
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
inline constexpr Profile on_wall{inverse_sqrt_pi, 0, 2 * inverse_sqrt_pi};

/// What a curved wall takes from the mean distance of a core on it, in cores; no more than the
/// sharpest edge.
inline constexpr double sharpest = inverse_sqrt_pi / 2;
inline double bend(double s, double kappa) {
  return std::min(kappa * s / 8, sharpest);
}

/// A core of width 1 at a distance q from a wall that takes `bend` of its mean: its mean distance m
/// and variance v_n across the wall (in a concave one, that at a flat wall), and their derivatives
/// by q; and what they lose with the bend, -d m/d bend and -d v_n/d bend.
struct Bent {
  double mean, slope, across, across_slope, taken, across_taken;

  Bent(double q, double bend) : Bent(profile(q), q, bend) {}
  Bent(const Profile& at, double q, double bend) {
    const double beyond = 1 - at.erf, bell = at.slope / (2 * inverse_sqrt_pi);
    const double convex = std::max(bend, 0.0);
    constexpr double part = 4 * inverse_sqrt_pi / 3;
    taken = (1 - 2 * q * q) * beyond + q * at.slope;
    mean = at.mean - bend * taken;
    slope = at.erf + 4 * bend * q * beyond;
    const double least = at.mean - convex * taken;
    const double lost = part * ((1 - 2 * q * q) * bell + 2 / inverse_sqrt_pi * q * q * q * beyond);
    across = 0.5 + q * q - least * least - convex * lost;
    across_slope = 2 * q - 2 * least * (at.erf + 4 * convex * q * beyond) +
                   6 * part * convex * q * (bell - q * beyond / inverse_sqrt_pi);
    across_taken = bend > 0 ? lost - 2 * least * taken : 0;
  }
};

/// Mean distance and variance across the wall.
struct MeanAndVariance {
  double mean, across;
};
inline MeanAndVariance moments(double y, double s, double kappa) {
  if (!applies(y, s)) return {y, s * s / 2};
  const Bent at(y / s, bend(s, kappa));
  return {s * at.mean, s * s * at.across};
}

inline double mean_distance(double y, double s, double kappa) {
  return moments(y, s, kappa).mean;
}

/// The curvature that a core of the variance v_t along the wall follows: all of it up to
/// 1/sqrt(8 v_t), less and less beyond, none from 3/2 of that on. A core around a tip stays
/// straight.
inline double followed(double along, double kappa) {
  const double most = 1 / std::sqrt(8 * along);
  return kappa * std::clamp(3 - 2 * std::abs(kappa) / most, 0.0, 1.0);
}

/// The sag of a core of these variances, its own across the wall and along it.
inline double sag(double across, double along, double kappa) {
  return followed(along, kappa) / 2 * (along - across);
}

/// What is folded: a Gaussian by the distance of its centre and its width.
struct Gaussian {
  double y, s;
};

/// The core whose mean distance is m - k s^2/4, k the curvature that it follows: the centre is
/// found for the given s; where even a centre on the wall lies too far out, the core is squeezed,
/// never below `thinnest` of it. (A core whose mean is at a distance d has m = d + k v_t/2,
/// whatever its width across the wall; k = 0: a round one, m its mean distance.)
Gaussian place(double m, double s, double kappa, double k = 0);

/// The same core whose variance across the wall is v_n. A wider distribution than that of a centre
/// on the wall, v_n > (pi/2 - 1) m^2 at a flat one, is none of a folded core: it gets the mean
/// alone. No mean is nearer than `thinnest` sqrt(2 v_n/pi).
///
/// error  1e-9 of the mean; of v_n 1e-8 at a flat wall, 1e-6 at a bent one
///        (tests/vortex/cores/folded_centroid.cpp)
Gaussian place_with_variance(double m, double v_n, double kappa, double k = 0);

}  // namespace folded
}  // namespace vortree::vortex
