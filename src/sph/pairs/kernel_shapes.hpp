#pragma once

#include <algorithm>
#include <cmath>

#include "sph/pairs/kernels.hpp"

namespace vortree::sph {

/// The kernels of kernels.hpp in d dimensions as types, for loops over pairs that are compiled for
/// one of them.
///
///   shape(q)         as in the table there
///   slope_over_q(q)  1/q dshape/dq, for the gradient (x, y) norm/h^(d + 2) slope_over_q; at q = 0
///                    that of a flat top, and 0 of a cusp, which has no gradient there
///
/// zero from the support on, without a branch but for gaussian.
///
/// twin    tests/sph/pairs/papers.hpp, the formulas as printed

/// t^n by squares.
template <int n>
constexpr double power(double t) {
  if constexpr (n == 1)
    return t;
  else if constexpr (n % 2 == 0)
    return power<n / 2>(t * t);
  else
    return power<n / 2>(t * t) * t;
}

/// How far q lies below an edge; 0 beyond.
constexpr double below(double edge, double q) {
  return std::max(0.0, edge - q);
}

constexpr double over_q(double slope, double q) {
  return q > 0 ? slope / q : 0;
}

template <int d>
struct WendlandC2 {
  static constexpr double support = 2;
  static constexpr double shape(double q) {
    const double t = below(1, q / 2);
    return d == 1 ? power<3>(t) * (1.5 * q + 1) : power<4>(t) * (2 * q + 1);
  }
  static constexpr double slope_over_q(double q) {
    const double t = below(1, q / 2);
    return d == 1 ? -3 * power<2>(t) : -5 * power<3>(t);
  }
};

template <int d>
struct WendlandC4 {
  static constexpr double support = 2;
  static constexpr double shape(double q) {
    const double t = below(1, q / 2);
    return d == 1 ? power<5>(t) * ((2 * q + 2.5) * q + 1)
                  : power<6>(t) * ((35.0 / 12 * q + 3) * q + 1);
  }
  static constexpr double slope_over_q(double q) {
    const double t = below(1, q / 2);
    return d == 1 ? power<4>(t) * (-7 * q - 3.5) : power<5>(t) * (-35.0 / 3 * q - 14.0 / 3);
  }
};

template <int d>
struct WendlandC6 {
  static constexpr double support = 2;
  static constexpr double shape(double q) {
    const double t = below(1, q / 2);
    return d == 1 ? power<7>(t) * (((2.625 * q + 4.75) * q + 3.5) * q + 1)
                  : power<8>(t) * (((4 * q + 6.25) * q + 4) * q + 1);
  }
  static constexpr double slope_over_q(double q) {
    const double t = below(1, q / 2);
    return d == 1 ? power<6>(t) * ((-13.125 * q - 13.5) * q - 4.5)
                  : power<7>(t) * ((-22 * q - 19.25) * q - 5.5);
  }
};

struct CubicSpline {
  static constexpr double support = 2;
  static constexpr double shape(double q) {
    return power<3>(below(2, q)) - 4 * power<3>(below(1, q));
  }
  static constexpr double slope_over_q(double q) {
    return over_q(-3 * power<2>(below(2, q)) + 12 * power<2>(below(1, q)), q);
  }
};

struct QuinticSpline {
  static constexpr double support = 3;
  static constexpr double shape(double q) {
    return power<5>(below(3, q)) - 6 * power<5>(below(2, q)) + 15 * power<5>(below(1, q));
  }
  static constexpr double slope_over_q(double q) {
    return over_q(
        -5 * power<4>(below(3, q)) + 30 * power<4>(below(2, q)) - 75 * power<4>(below(1, q)), q);
  }
};

struct GaussianKernel {
  static constexpr double support = 3;
  static double shape(double q) { return q < support ? std::exp(-q * q) : 0; }
  static double slope_over_q(double q) { return -2 * shape(q); }
};

struct Quadratic {
  static constexpr double support = 2;
  static constexpr double shape(double q) { return power<2>(below(1, q / 2)); }
  static constexpr double slope_over_q(double q) { return over_q(-below(1, q / 2), q); }
};

struct Bell {
  static constexpr double support = 1;
  static constexpr double shape(double q) { return (1 + 3 * q) * power<3>(below(1, q)); }
  static constexpr double slope_over_q(double q) { return -12 * power<2>(below(1, q)); }
};

/// use(shape), with an object of the kernel's type: a choice made once, outside of all loops.
template <int d, class Use>
decltype(auto) with_shape(Kernel kernel, const Use& use) {
  switch (kernel) {
    case Kernel::wendland_c2:
      return use(WendlandC2<d>{});
    case Kernel::wendland_c4:
      return use(WendlandC4<d>{});
    case Kernel::wendland_c6:
      return use(WendlandC6<d>{});
    case Kernel::cubic_spline:
      return use(CubicSpline{});
    case Kernel::quintic_spline:
      return use(QuinticSpline{});
    case Kernel::gaussian:
      return use(GaussianKernel{});
    case Kernel::quadratic:
      return use(Quadratic{});
    default:
      return use(Bell{});
  }
}

}  // namespace vortree::sph
