#include "vortex/cores/folded_core.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace vortree::vortex::folded {
namespace {

constexpr int per_core = 64, nodes = per_core * static_cast<int>(support) + 1, terms = 10;
constexpr double past_nodes = (nodes - 0.5) / per_core;
using Taylor = std::array<double, terms>;

/// The mean's Taylor series about each node q: its second derivative is 2/sqrt(pi) exp(-q^2), whose
/// derivatives are that times a_n, a_(n+1) = -2 q a_n - 2 n a_(n-1).
std::array<Taylor, nodes> series_about_nodes() {
  std::array<Taylor, nodes> all;
  for (int k = 0; k < nodes; ++k) {
    const double q = static_cast<double>(k) / per_core, bell = std::exp(-q * q);
    all[k][0] = inverse_sqrt_pi * bell + q * std::erf(q);
    all[k][1] = std::erf(q);
    double factorial = 2, before = 0, now = 1;
    for (int n = 0; n + 2 < terms; ++n) {
      all[k][n + 2] = 2 * inverse_sqrt_pi * bell * now / factorial;
      factorial *= n + 3;
      before = std::exchange(now, -2 * q * now - 2 * n * before);
    }
  }
  return all;
}

const std::array<Taylor, nodes> about = series_about_nodes();

}  // namespace

Profile profile(double q) {
  const double size = std::abs(q);
  if (!(size < past_nodes)) return {size, std::copysign(1.0, q), 0};
  const int k = static_cast<int>(size * per_core + 0.5);
  const double d = size - static_cast<double>(k) / per_core;
  const Taylor& c = about[k];
  Profile at{c[terms - 1], 0, 0};
  double half_slope = 0;
  for (int n = terms - 2; n >= 0; --n) {
    half_slope = half_slope * d + at.erf;
    at.erf = at.erf * d + at.mean;
    at.mean = at.mean * d + c[n];
  }
  at.slope = 2 * half_slope;
  at.erf = std::copysign(at.erf, q);
  return at;
}

Gaussian place(double m, double s, double kappa) {
  if (!applies(m, s)) return {m, s};
  m = std::max(m, thinnest * s * inverse_sqrt_pi);
  const double bend = folded::bend(s, kappa);
  const double on_wall = s * (inverse_sqrt_pi - bend);  // mean distance of a centre on the wall
  if (m <= on_wall) {
    // m = s'/sqrt(pi) - kappa s'^2/8, the smaller root; past the sharpest edge m = s'/(2 sqrt(pi)).
    const double a = inverse_sqrt_pi;
    return {0, std::min(s, 2 * m / (a + std::sqrt(std::max(a * a - kappa * m / 2, 0.0))))};
  }
  // Near the wall m - on_wall = y^2/s (1/sqrt(pi) + 2 bend): a start from which Newton does not
  // overshoot.
  double y = std::sqrt((m - on_wall) * s / (inverse_sqrt_pi + 2 * bend));
  for (int k = 0; k < 12; ++k) {
    const double q = y / s;
    const Profile at = profile(q);
    const double mean = s * (at.mean - bend * ((1 - 2 * q * q) * (1 - at.erf) + q * at.slope));
    const double slope = at.erf + 4 * bend * q * (1 - at.erf);
    const double next = std::max(y - (mean - m) / slope, 0.0);
    // The error after a step is less than the square of the step over y.
    const bool settled = next == 0 || std::abs(next - y) <= 1e-8 * next;
    y = next;
    if (settled) break;
  }
  return {y, s};
}

namespace {

/// A core of width s, in units of that, at a distance q from a wall that takes `bend` of its mean.
struct Bent {
  double mean, slope;

  Bent(double q, double bend) {
    const Profile at = profile(q);
    mean = at.mean - bend * ((1 - 2 * q * q) * (1 - at.erf) + q * at.slope);
    slope = at.erf + 4 * bend * q * (1 - at.erf);
  }
};

/// q = y/s of which (1/2 + q^2)/mean(q)^2 is `second`, E[n^2]/E[n]^2, of the core whose mean
/// distance is m: largest on the wall, at a flat one whence it falls as 1 - 2/3 q^4, at a convex
/// one with 6 bend/(1/sqrt(pi) - bend) q^2 besides.
///
/// on_wall  the core's width if its centre were on the wall
double depth(double second, double m, double on_wall, double kappa) {
  double b = bend(on_wall, kappa);
  const double edge = inverse_sqrt_pi - b, square = std::max(6 * b / edge, 0.0);
  const double fallen = std::max(1 - 2 * second * edge * edge, 0.0);
  const double start = 0.75 * (std::sqrt(square * square + 8.0 / 3 * fallen) - square);
  double q = std::max(std::sqrt(start), 1e-5);
  if (q > 0.6) q = std::sqrt(0.5 / (second - 1));
  for (int k = 0; k < 20 && q < support; ++k) {
    b = bend(m / Bent(q, b).mean, kappa);
    const auto [mean, rise] = Bent(q, b);
    const double ratio = (0.5 + q * q) / (mean * mean);
    const double slope = 2 * (q - ratio * mean * rise) / (mean * mean);
    const double next = std::max(q - (ratio - second) / slope, q / 2);
    if (std::abs(next - q) <= 1e-7 * q) return next;
    q = next;
  }
  return q;
}

}  // namespace

Gaussian place_with_variance(double m, double v_n, double kappa) {
  m = std::max(m, thinnest * inverse_sqrt_pi * std::sqrt(2 * v_n));
  const double convex = std::max(kappa, 0.0), square = v_n + m * m;
  const double on_wall = place(m, 2 * m / inverse_sqrt_pi, convex).s;
  if (square >= on_wall * on_wall / 2 - 1e-9 * m * m) return place(m, on_wall, kappa);
  const double q = depth(square / (m * m), m, on_wall, convex);
  const double s = q < support ? std::sqrt(square / (0.5 + q * q)) : std::sqrt(2 * v_n);
  return place(m, s, kappa);
}

}  // namespace vortree::vortex::folded
